// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/ceres/pose_problem.h"

#include <ceres/loss_function.h>

#include "backend/cost/edge_error.h"
#include "plugins/ceres/edge_cost_function.h"

namespace gmapping_spa::ceres_backend {
namespace {

::ceres::Problem::Options ProblemOptions() {
  ::ceres::Problem::Options options;
  options.loss_function_ownership = ::ceres::DO_NOT_TAKE_OWNERSHIP;
  return options;
}

}  // namespace

class PoseProblem::RobustLoss : public ::ceres::LossFunction {
 public:
  explicit RobustLoss(const backend::Loss& loss) : loss_(loss) {}
  void Evaluate(double s, double rho[3]) const override {
    const backend::LossValue value = backend::EvaluateLoss(loss_, s);
    rho[0] = value.rho;
    rho[1] = value.weight;
    rho[2] = 0.0;  // plain reweighting, as SPA does
  }

 private:
  backend::Loss loss_;
};

PoseProblem::PoseProblem(const backend::PoseGraphView& graph, const backend::GraphIndex& index,
                         const backend::Loss& loss)
    : poses_(PosesOf(graph)),
      loss_(std::make_unique<RobustLoss>(loss)),
      problem_(ProblemOptions()) {
  static_assert(sizeof(backend::SE2) == 3 * sizeof(double));
  for (std::size_t node = 0; node < poses_.size(); ++node) {
    problem_.AddParameterBlock(&poses_[node].x, 3);
    if (index.fixed[node]) problem_.SetParameterBlockConstant(&poses_[node].x);
  }
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const backend::Edge& edge = graph.edges[k];
    const auto [i, j] = index.edges[k];
    if (i == j) continue;  // no pose changes its error
    const bool trusted = backend::LossOfEdge(edge, loss) == backend::Loss{};
    problem_.AddResidualBlock(new EdgeCostFunction(edge), trusted ? nullptr : loss_.get(),
                              &poses_[i].x, &poses_[j].x);
  }
}

PoseProblem::~PoseProblem() = default;

}  // namespace gmapping_spa::ceres_backend
