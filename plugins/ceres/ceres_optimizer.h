// SPDX-License-Identifier: BSD-3-Clause
// Ceres as a back end.
#ifndef GMAPPING_SPA_PLUGINS_CERES_CERES_OPTIMIZER_H_
#define GMAPPING_SPA_PLUGINS_CERES_CERES_OPTIMIZER_H_

#include <vector>

#include "backend/plugin/optimizer.h"
#include "backend/plugin/settings.h"

namespace gmapping_spa::ceres_backend {

// Ceres' trust-region solver on the same errors, Jacobians and losses as SPA.
//
// Options::cost_tolerance is Ceres' function_tolerance. Initialization kAuto is kKeep. Settings
// have the names and the meaning that they have in ceres::Solver::Options.
class CeresOptimizer : public backend::StatelessOptimizer {
 public:
  static constexpr backend::SettingDescription kSettings[] = {
      backend::ChoiceSetting("linear_solver", "sparse_normal_cholesky",
                             "sparse_normal_cholesky,dense_normal_cholesky,dense_qr,cgnr",
                             "linear_solver_type"),
      backend::ChoiceSetting("sparse_library", "suite_sparse", "suite_sparse,eigen_sparse",
                             "sparse_linear_algebra_library_type"),
      backend::ChoiceSetting("trust_region", "levenberg_marquardt", "levenberg_marquardt,dogleg",
                             "trust_region_strategy_type"),
      backend::NumberSetting("initial_radius", "1e4",
                             "initial_trust_region_radius; 1e16 is nearly Gauss-Newton, and faster "
                             "on most graphs",
                             0.0),
      backend::BooleanSetting("nonmonotonic", "false",
                              "use_nonmonotonic_steps: steps may raise the cost for a while"),
      backend::BooleanSetting("jacobi_scaling", "true",
                              "jacobi_scaling: scale the columns of the Jacobian"),
      backend::NumberSetting("gradient_tolerance", "1e-10",
                             "converged when the largest component of the gradient is below this",
                             0.0),
      backend::NumberSetting("parameter_tolerance", "1e-8",
                             "converged when a step is below this part of the parameters", 0.0),
      backend::IntegerSetting("threads", "1", "num_threads", 1)};
  static constexpr backend::LossKind kLosses[] = {
      backend::LossKind::kHuber, backend::LossKind::kCauchy, backend::LossKind::kDcs,
      backend::LossKind::kTruncated};

  void CheckOptions(const backend::Options& options) const override;
  backend::Summary Optimize(const backend::Options& options, std::span<const backend::Edge> edges,
                            std::span<backend::Node> nodes) override;
  // By ceres::Covariance.
  bool HasCovariances() const override { return true; }
  std::vector<Eigen::Matrix3d> Covariances(std::span<const backend::Edge> edges,
                                           std::span<const backend::Node> nodes,
                                           std::span<const backend::EdgeNodes> pairs) override;
};

}  // namespace gmapping_spa::ceres_backend

#endif  // GMAPPING_SPA_PLUGINS_CERES_CERES_OPTIMIZER_H_
