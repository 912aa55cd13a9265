// SPDX-License-Identifier: BSD-3-Clause
// The cost that every optimizer lowers, computed apart from all of them.
#ifndef GMAPPING_SPA_BACKEND_COST_GRAPH_COST_H_
#define GMAPPING_SPA_BACKEND_COST_GRAPH_COST_H_

#include <vector>

#include "backend/cost/robust_loss.h"
#include "backend/graph/graph_index.h"
#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// Sum over the edges of rho(e' Omega e) / 2, where rho is `loss` for loop closures and the identity
// for all other edges. Without a loss this is 1/2 sum e' Omega e.
double GraphCost(const PoseGraphView& graph, const GraphIndex& index, const Loss& loss = {});

// The same with other poses, one for each node, than those in the graph.
double GraphCost(const PoseGraphView& graph, const GraphIndex& index, const std::vector<SE2>& poses,
                 const Loss& loss = {});

// The squared errors e' Omega e, one for each edge, with these poses, one for each node.
std::vector<double> SquaredErrors(const PoseGraphView& graph, const GraphIndex& index,
                                  const std::vector<SE2>& poses);

// The first one for a graph without an index; throws like IndexGraph.
double GraphCost(const PoseGraphView& graph, const Loss& loss = {});

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_COST_GRAPH_COST_H_
