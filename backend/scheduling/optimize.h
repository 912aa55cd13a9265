// SPDX-License-Identifier: BSD-3-Clause
// Optimizing a graph under any loss.
#ifndef GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_H_
#define GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_H_

#include <vector>

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// OptimizeRobustly under LossKind::kMixture, OptimizeGradually under LossKind::kTruncated with
// `graduated`, else OptimizeSafely. Fills Summary::edge_weights; where loop closures are rejected,
// the message says how many, and whether that is most of them.
Summary Optimize(const Options& options, bool graduated, Optimizer* optimizer, PoseGraph* graph);

// Throws like Optimizer::CheckOptions when the optimizer cannot do what Optimize would ask it for.
void CheckOptions(const Options& options, const Optimizer& optimizer);

// Positions among `edges` of the loop closures that an optimization rejected.
std::vector<std::size_t> RejectedClosures(std::span<const Edge> edges, const Summary& summary);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_H_
