// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/finished_view.h"

#include <cstddef>
#include <memory>
#include <utility>

#include "experiments/view/page_files.h"

namespace gmapping_spa::view {
namespace {

std::vector<ViewedRun> Viewed(const std::vector<FinishedRun>& runs,
                              std::deque<FigureHistory>* histories) {
  std::vector<ViewedRun> viewed;
  for (const FinishedRun& run : runs) {
    FigureHistory& history = histories->emplace_back(kHistoryRows);
    for (const Figures& figures : run.history) history.Add(figures);
    viewed.push_back({run.title, &history});
  }
  return viewed;
}

}  // namespace

FinishedView::FinishedView(const ServerOptions& options, std::vector<FinishedRun> runs)
    : hub_(Viewed(runs, &histories_), nullptr), server_(options, PageFiles(), hub_.Protocols()) {
  for (std::size_t run = 0; run < runs.size(); ++run) {
    server_.Post([this, run, shared = std::make_shared<Snapshot>(std::move(runs[run].snapshot))] {
      hub_.Apply(static_cast<int>(run), std::move(*shared));
    });
  }
}

}  // namespace gmapping_spa::view
