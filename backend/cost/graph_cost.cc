// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/graph_cost.h"

#include "backend/cost/edge_error.h"

namespace gmapping_spa::backend {
namespace {

template <typename PoseOfNode>
double SumCost(const PoseGraphView& graph, const GraphIndex& index, const Loss& loss,
               const PoseOfNode& pose) {
  double cost = 0.0;
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const Eigen::Vector3d error =
        EdgeError(pose(index.edges[k].i), pose(index.edges[k].j), edge.i_T_j);
    const double s = error.dot(edge.information * error);
    cost += EvaluateLoss(LossOfEdge(edge, loss), s).rho / 2.0;
  }
  return cost;
}

}  // namespace

double GraphCost(const PoseGraphView& graph, const GraphIndex& index, const Loss& loss) {
  return SumCost(graph, index, loss,
                 [&](int node) -> const SE2& { return graph.nodes[node].world_T_node; });
}

double GraphCost(const PoseGraphView& graph, const GraphIndex& index, const std::vector<SE2>& poses,
                 const Loss& loss) {
  return SumCost(graph, index, loss, [&](int node) -> const SE2& { return poses[node]; });
}

std::vector<double> SquaredErrors(const PoseGraphView& graph, const GraphIndex& index,
                                  const std::vector<SE2>& poses) {
  std::vector<double> squared(graph.edges.size());
  for (std::size_t k = 0; k < squared.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const Eigen::Vector3d error =
        EdgeError(poses[index.edges[k].i], poses[index.edges[k].j], edge.i_T_j);
    squared[k] = error.dot(edge.information * error);
  }
  return squared;
}

double GraphCost(const PoseGraphView& graph, const Loss& loss) {
  return GraphCost(graph, IndexGraph(graph), loss);
}

}  // namespace gmapping_spa::backend
