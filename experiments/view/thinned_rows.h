// SPDX-License-Identifier: BSD-3-Clause
// Rows over time, in bounded memory however many come.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_THINNED_ROWS_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_THINNED_ROWS_H_

#include <cstddef>
#include <utility>
#include <vector>

namespace gmapping_spa::view {

// Keeps every row first; when it is full, it drops every second one and keeps every second of
// those to come, and so on.
template <typename Row>
class ThinnedRows {
 public:
  explicit ThinnedRows(std::size_t capacity) : capacity_(capacity) {}

  void Add(const Row& row) {
    if (seen_++ % step_ != 0) return;
    if (rows_.size() == capacity_) {
      std::vector<Row> half;
      half.reserve(capacity_);
      for (std::size_t i = 0; i < rows_.size(); i += 2) half.push_back(rows_[i]);
      rows_ = std::move(half);
      step_ *= 2;
      if ((seen_ - 1) % step_ != 0) return;
    }
    rows_.push_back(row);
  }

  // Between half the capacity and all of it once it was full; evenly apart, the first one included.
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::size_t capacity_;
  std::size_t step_ = 1;  // of rows, one is kept
  std::size_t seen_ = 0;
  std::vector<Row> rows_;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_THINNED_ROWS_H_
