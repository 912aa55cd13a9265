// SPDX-License-Identifier: BSD-3-Clause
// Runs that are over, to look at.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_FINISHED_VIEW_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_FINISHED_VIEW_H_

#include <cstdint>
#include <deque>
#include <vector>

#include "experiments/view/figure_history.h"
#include "experiments/view/snapshot.h"
#include "experiments/view/view_hub.h"
#include "experiments/view/view_server.h"

namespace gmapping_spa::view {

struct FinishedRun {
  RunTitle title;
  Snapshot snapshot;
  std::vector<Figures> history;  // in the order of time
};

// Serves them, side by side, as long as it lives.
class FinishedView {
 public:
  // Throws as ViewServer does.
  FinishedView(const ServerOptions& options, std::vector<FinishedRun> runs);

  std::uint16_t port() const { return server_.port(); }

 private:
  std::deque<FigureHistory> histories_;
  ViewHub hub_;
  ViewServer server_;  // ends before what its conversations use
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_FINISHED_VIEW_H_
