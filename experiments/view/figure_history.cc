// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/figure_history.h"

#include <utility>

namespace gmapping_spa::view {

void FigureHistory::Add(const Figures& figures) {
  const std::lock_guard lock(mutex_);
  if (seen_++ % step_ != 0) return;
  if (rows_.size() == capacity_) {
    std::vector<Figures> half;
    half.reserve(capacity_);
    for (std::size_t i = 0; i < rows_.size(); i += 2) half.push_back(rows_[i]);
    rows_ = std::move(half);
    step_ *= 2;
    if ((seen_ - 1) % step_ != 0) return;
  }
  rows_.push_back(figures);
}

std::vector<Figures> FigureHistory::Rows() const {
  const std::lock_guard lock(mutex_);
  return rows_;
}

}  // namespace gmapping_spa::view
