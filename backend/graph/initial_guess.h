// SPDX-License-Identifier: BSD-3-Clause
// Initial poses by chaining measurements.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_INITIAL_GUESS_H_
#define GMAPPING_SPA_BACKEND_GRAPH_INITIAL_GUESS_H_

#include <vector>

#include "backend/graph/graph_index.h"
#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// Replaces those of `poses` (one for each node) that are not held by what follows from a held one
// along odometry and scan-match edges, crossing a loop closure only where nothing else leads on.
void InitializeFromOdometry(const PoseGraphView& graph, const GraphIndex& index,
                            std::vector<SE2>* poses);

// The same along a breadth-first spanning tree of all edges: short chains, so little drift, at the
// mercy of wrong loop closures.
void InitializeFromSpanningTree(const PoseGraphView& graph, const GraphIndex& index,
                                std::vector<SE2>* poses);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_INITIAL_GUESS_H_
