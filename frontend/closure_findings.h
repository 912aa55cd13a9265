// SPDX-License-Identifier: BSD-3-Clause
// What a run has to say about loop closures when all scans are in.
#ifndef GMAPPING_SPA_FRONTEND_CLOSURE_FINDINGS_H_
#define GMAPPING_SPA_FRONTEND_CLOSURE_FINDINGS_H_

#include <functional>
#include <vector>

#include "frontend/graph_thread.h"
#include "frontend/health.h"
#include "frontend/loop_closure/unproven.h"

namespace gmapping_spa::frontend {

using StampOfNode = std::function<double(int node)>;

// "backend_rejected_closure": those that the back end gives no weight.
void ReportRejectedClosures(const std::vector<GraphThread::RejectedClosure>& rejected,
                            const StampOfNode& stamp_of_node, Health* health);

// "unproven_closures": those that nobody decided about, though they would move the map.
void ReportUnprovenClosures(const std::vector<loop_closure::UnprovenClosure>& unproven,
                            const StampOfNode& stamp_of_node, Health* health);

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_CLOSURE_FINDINGS_H_
