// SPDX-License-Identifier: BSD-3-Clause
// The figures of a run over time, in bounded memory however long it takes.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FIGURE_HISTORY_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FIGURE_HISTORY_H_

#include <cstddef>
#include <mutex>
#include <vector>

#include "experiments/view/snapshot.h"

namespace gmapping_spa::view {

// Keeps every figure first; when it is full, it drops every second one and keeps every second of
// those to come, and so on.
class FigureHistory {
 public:
  explicit FigureHistory(std::size_t capacity) : capacity_(capacity) {}

  // Both in any thread.
  void Add(const Figures& figures);
  // Between half the capacity and all of it once it was full; evenly apart, the first one included.
  std::vector<Figures> Rows() const;

 private:
  mutable std::mutex mutex_;
  std::size_t capacity_;
  std::size_t step_ = 1;  // of figures, one is kept
  std::size_t seen_ = 0;
  std::vector<Figures> rows_;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FIGURE_HISTORY_H_
