// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/number_rows.h"

#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "backend/text.h"

namespace gmapping_spa::backend {

NumberRows::NumberRows(std::istream& in, std::string name, std::string columns)
    : in_(in),
      name_(std::move(name)),
      columns_(std::move(columns)),
      column_count_(WordsOf(columns_).size()) {}

bool NumberRows::Next() {
  std::string line;
  while (std::getline(in_, line)) {
    ++line_;
    const std::string_view text = line_ == 1 ? WithoutByteOrderMark(line) : line;
    const std::vector<std::string_view> words = WordsOf(WithoutComment(text));
    if (words.empty()) continue;
    if (words.size() != column_count_) {
      Fail(std::to_string(column_count_) + " columns (" + columns_ + ")",
           std::to_string(words.size()));
    }
    row_.clear();
    for (const std::string_view word : words) {
      const std::optional<double> value = ParseFinite<double>(word);
      if (!value) Fail("a finite number", Quoted(word));
      row_.push_back(*value);
    }
    return true;
  }
  if (in_.bad()) throw std::runtime_error(name_ + ": cannot be read");
  return false;
}

void NumberRows::Fail(const std::string& expected, const std::string& found) const {
  throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": expected " + expected +
                           ", found " + found);
}

}  // namespace gmapping_spa::backend
