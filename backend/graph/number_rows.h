// SPDX-License-Identifier: BSD-3-Clause
// Text files that hold one row of numbers a line, such as TUM trajectories.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_NUMBER_ROWS_H_
#define GMAPPING_SPA_BACKEND_GRAPH_NUMBER_ROWS_H_

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace gmapping_spa::backend {

// Reads rows one at a time, skipping blank lines, comments (from '#' to the end of the line) and a
// byte order mark. Every error is a std::runtime_error of one line, "<name>:<line>: expected
// <what>, found <what>".
class NumberRows {
 public:
  // `name` is for messages. `columns` names the columns of a row, separated by blanks.
  NumberRows(std::istream& in, std::string name, std::string columns);

  // Moves to the next row; false at the end of the stream. Throws when the row has another number
  // of columns, when one of them is not a finite number, and when the stream cannot be read.
  bool Next();

  const std::vector<double>& row() const { return row_; }

  // Throws an error about the current row: for what is wrong with numbers that could be read.
  [[noreturn]] void Fail(const std::string& expected, const std::string& found) const;

 private:
  std::istream& in_;
  std::string name_;
  std::string columns_;
  std::size_t column_count_;
  std::vector<double> row_;
  int line_ = 0;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_NUMBER_ROWS_H_
