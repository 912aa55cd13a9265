// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/graph_cost.h"

#include "backend/cost/edge_error.h"

namespace gmapping_spa::backend {
namespace {

// Calls visit(k, e' Omega e) for each edge k.
template <typename PoseOfNode, typename Visit>
void ForEachSquaredError(const PoseGraphView& graph, const GraphIndex& index,
                         const PoseOfNode& pose, const Visit& visit) {
  std::vector<Heading> headings;
  headings.reserve(graph.nodes.size());
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) headings.push_back(HeadingOf(pose(k)));
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const auto [i, j] = index.edges[k];
    const Eigen::Vector3d error = EdgeError(pose(i), headings[i], pose(j), edge.i_T_j);
    visit(k, error.dot(edge.information * error));
  }
}

template <typename PoseOfNode>
double SumCost(const PoseGraphView& graph, const GraphIndex& index, const Loss& loss,
               const PoseOfNode& pose) {
  double cost = 0.0;
  ForEachSquaredError(graph, index, pose, [&](std::size_t k, double s) {
    cost += EvaluateLoss(LossOfEdge(graph.edges[k], loss), s).rho / 2.0;
  });
  return cost;
}

}  // namespace

double GraphCost(const PoseGraphView& graph, const GraphIndex& index, const Loss& loss) {
  return SumCost(graph, index, loss,
                 [&](std::size_t node) -> const SE2& { return graph.nodes[node].world_T_node; });
}

double GraphCost(const PoseGraphView& graph, const GraphIndex& index, const std::vector<SE2>& poses,
                 const Loss& loss) {
  return SumCost(graph, index, loss, [&](std::size_t node) -> const SE2& { return poses[node]; });
}

std::vector<double> SquaredErrors(const PoseGraphView& graph, const GraphIndex& index,
                                  const std::vector<SE2>& poses) {
  std::vector<double> squared(graph.edges.size());
  ForEachSquaredError(
      graph, index, [&](std::size_t node) -> const SE2& { return poses[node]; },
      [&](std::size_t k, double s) { squared[k] = s; });
  return squared;
}

double GraphCost(const PoseGraphView& graph, const Loss& loss) {
  return GraphCost(graph, IndexGraph(graph), loss);
}

}  // namespace gmapping_spa::backend
