// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/closure_findings.h"

#include <algorithm>
#include <string>

#include "backend/text.h"

namespace gmapping_spa::frontend {

void ReportRejectedClosures(const std::vector<GraphThread::RejectedClosure>& rejected,
                            const StampOfNode& stamp_of_node, Health* health) {
  for (const auto& [i, j, weight] : rejected) {
    health->Report("backend_rejected_closure", stamp_of_node(static_cast<int>(std::max(i, j))),
                   "the back end rejects the loop closure between nodes " + std::to_string(i) +
                       " and " + std::to_string(j) + ": the other edges contradict it");
  }
}

void ReportUnprovenClosures(const std::vector<loop_closure::UnprovenClosure>& unproven,
                            const StampOfNode& stamp_of_node, Health* health) {
  for (const auto& [node, moved_m] : unproven) {
    health->Report(
        "unproven_closures", stamp_of_node(node),
        "a loop may close here whose closure is not proven: it would move the robot by " +
            backend::FixedText(moved_m, 1) + " m, and the map may be bent");
  }
}

}  // namespace gmapping_spa::frontend
