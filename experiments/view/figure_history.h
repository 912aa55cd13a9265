// SPDX-License-Identifier: BSD-3-Clause
// The figures of a run over time, in bounded memory however long it takes. In any thread.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FIGURE_HISTORY_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FIGURE_HISTORY_H_

#include <cstddef>
#include <mutex>
#include <vector>

#include "experiments/view/snapshot.h"
#include "experiments/view/thinned_rows.h"

namespace gmapping_spa::view {

// Of a run that is shown.
inline constexpr std::size_t kHistoryRows = 2048;

class FigureHistory {
 public:
  explicit FigureHistory(std::size_t capacity) : rows_(capacity) {}

  void Add(const Figures& figures) {
    const std::lock_guard lock(mutex_);
    rows_.Add(figures);
  }
  std::vector<Figures> Rows() const {
    const std::lock_guard lock(mutex_);
    return rows_.rows();
  }

 private:
  mutable std::mutex mutex_;
  ThinnedRows<Figures> rows_;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FIGURE_HISTORY_H_
