// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/graph_cost.h"

#include "backend/cost/edge_error.h"

namespace gmapping_spa::backend {
namespace {

// Calls visit(k, e' Omega e) for each edge k.
template <typename Visit>
void ForEachSquaredError(const PoseGraphView& graph, const GraphIndex& index,
                         const std::vector<SE2>& poses, const Visit& visit) {
  const std::vector<Heading> headings = HeadingsOf(poses);
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const auto [i, j] = index.edges[k];
    const Eigen::Vector3d error = EdgeError(poses[i], headings[i], poses[j], edge.i_T_j);
    visit(k, error.dot(edge.information * error));
  }
}

}  // namespace

double GraphCost(const PoseGraphView& graph, const GraphIndex& index, const Loss& loss) {
  return GraphCost(graph, index, PosesOf(graph), loss);
}

double GraphCost(const PoseGraphView& graph, const GraphIndex& index, const std::vector<SE2>& poses,
                 const Loss& loss) {
  double cost = 0.0;
  ForEachSquaredError(graph, index, poses, [&](std::size_t k, double s) {
    cost += EvaluateLoss(LossOfEdge(graph.edges[k], loss), s).rho / 2.0;
  });
  return cost;
}

std::vector<double> SquaredErrors(const PoseGraphView& graph, const GraphIndex& index,
                                  const std::vector<SE2>& poses) {
  std::vector<double> squared(graph.edges.size());
  ForEachSquaredError(graph, index, poses, [&](std::size_t k, double s) { squared[k] = s; });
  return squared;
}

double GraphCost(const PoseGraphView& graph, const Loss& loss) {
  return GraphCost(graph, IndexGraph(graph), loss);
}

}  // namespace gmapping_spa::backend
