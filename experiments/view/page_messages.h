// SPDX-License-Identifier: BSD-3-Clause
// What the page is told, as JSON; `run` counts the runs on the page from 0. README.md lists the
// messages.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_MESSAGES_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_MESSAGES_H_

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "experiments/view/message.h"
#include "experiments/view/snapshot.h"

namespace gmapping_spa::view {

struct RunTitle {
  std::string name;
  bool is_live = true;  // else it was finished before it was shown
  double resolution_m = 0.05;
};

// `session` is another text for each start of the program.
MessagePtr HelloMessage(const std::string& session, const std::vector<RunTitle>& runs);
MessagePtr ControlMessage(bool paused);
MessagePtr FrameMessage(int run, const Snapshot& snapshot);
MessagePtr HistoryMessage(int run, const std::vector<Figures>& rows);
MessagePtr HealthMessage(int run, const HealthSnapshot& health);

// `kind` is "nodes" or "trajectory": the poses from position `from` on; there are none behind them.
MessagePtr PosesMessage(const char* kind, int run, std::size_t from,
                        std::span<const backend::StampedPose> poses);

// Those candidates of all whose positions are listed.
MessagePtr CandidatesMessage(int run, const std::vector<loop_closure::ClosureRecord>& candidates,
                             const std::vector<std::size_t>& positions);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_PAGE_MESSAGES_H_
