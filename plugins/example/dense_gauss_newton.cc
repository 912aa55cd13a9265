// SPDX-License-Identifier: BSD-3-Clause
// An example of a back end: Gauss-Newton with dense matrices, for graphs of some hundred nodes.
#include <gmapping_spa/edge_error.h>
#include <gmapping_spa/graph_cost.h>
#include <gmapping_spa/plugin.h>

#include <Eigen/Cholesky>
#include <vector>

namespace {

using gmapping_spa::backend::Edge;
using gmapping_spa::backend::GraphCost;
using gmapping_spa::backend::GraphIndex;
using gmapping_spa::backend::LossKind;
using gmapping_spa::backend::Node;
using gmapping_spa::backend::Options;
using gmapping_spa::backend::PoseGraphView;
using gmapping_spa::backend::SE2;
using gmapping_spa::backend::Summary;
using gmapping_spa::backend::Termination;

// The change of all poses that solves J' Lambda J dx = -J' Lambda e; zero for fixed nodes.
Eigen::VectorXd GaussNewtonStep(const PoseGraphView& graph, const GraphIndex& index,
                                const std::vector<SE2>& poses, const Options& options) {
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(poses.size());
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const auto [i, j] = index.edges[k];
    const auto linear = LinearizeEdge(poses[i], poses[j], edge.i_T_j);
    const double s = linear.error.dot(edge.information * linear.error);
    const double weight = EvaluateLoss(LossOfEdge(edge, options.loss), s).weight;
    Eigen::Matrix<double, 3, 6> jacobian;
    jacobian << linear.jacobian_i, linear.jacobian_j;
    const Eigen::Matrix<double, 6, 3> weighted = weight * jacobian.transpose() * edge.information;
    const int at[] = {3 * i, 3 * j};
    for (int a = 0; a < 2; ++a) {
      gradient.segment<3>(at[a]) += weighted.middleRows<3>(3 * a) * linear.error;
      for (int b = 0; b < 2; ++b) {
        hessian.block<3, 3>(at[a], at[b]) +=
            weighted.middleRows<3>(3 * a) * jacobian.middleCols<3>(3 * b);
      }
    }
  }
  for (std::size_t node = 0; node < poses.size(); ++node) {
    if (!index.fixed[node]) continue;
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(node);
    hessian.middleRows<3>(at).setZero();
    hessian.middleCols<3>(at).setZero();
    hessian.block<3, 3>(at, at).setIdentity();
    gradient.segment<3>(at).setZero();
  }
  return -hessian.ldlt().solve(gradient);
}

class DenseGaussNewton : public gmapping_spa::backend::Optimizer {
 public:
  static constexpr LossKind kLosses[] = {LossKind::kHuber, LossKind::kCauchy, LossKind::kDcs,
                                         LossKind::kTruncated};

  Summary Optimize(const Options& options, std::span<const Edge> edges,
                   std::span<Node> nodes) override {
    const PoseGraphView graph{nodes, edges};
    const GraphIndex index = IndexGraph(graph);
    std::vector<SE2> poses = PosesOf(graph);
    Summary summary;
    summary.initial_cost = summary.final_cost = GraphCost(graph, index, options.loss);
    summary.termination = Termination::kNoConvergence;
    summary.message = "ran out of iterations";
    for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
      const Eigen::VectorXd step = GaussNewtonStep(graph, index, poses, options);
      for (std::size_t k = 0; k < poses.size(); ++k) {
        poses[k] = Plus(poses[k], step.segment<3>(3 * static_cast<Eigen::Index>(k)));
      }
      const double cost = GraphCost(graph, index, poses, options.loss);
      summary.iterations.push_back({.cost = cost, .step_norm = step.norm()});
      const double decrease = summary.final_cost - cost;
      if (cost < summary.final_cost) {  // an optimizer never returns worse poses than it got
        summary.final_cost = cost;
        for (std::size_t k = 0; k < poses.size(); ++k) nodes[k].world_T_node = poses[k];
      }
      if (!(decrease > options.cost_tolerance * summary.final_cost)) {
        summary.termination = Termination::kConverged;
        summary.message = "the cost no longer falls";
        break;
      }
    }
    return summary;
  }
};

}  // namespace

GMAPPING_SPA_BACKEND_PLUGIN(DenseGaussNewton, "dense_gauss_newton",
                            "Gauss-Newton with dense matrices");
