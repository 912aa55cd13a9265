// Ceres as a back end.
#ifndef GMAPPING_SPA_PLUGINS_CERES_CERES_OPTIMIZER_H_
#define GMAPPING_SPA_PLUGINS_CERES_CERES_OPTIMIZER_H_

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::ceres_backend {

// Ceres' trust-region solver on the same errors, Jacobians and losses as SPA.
//
// Settings, with the names and the meaning that they have in ceres::Solver::Options:
//   linear_solver          sparse_normal_cholesky (default), dense_normal_cholesky, dense_qr, cgnr
//   sparse_library         suite_sparse (default), eigen_sparse
//   trust_region           levenberg_marquardt (default), dogleg
//   initial_radius         initial_trust_region_radius; default 1e4, Ceres' own. 1e16 is nearly
//                          Gauss-Newton, and faster on most graphs
//   nonmonotonic           use_nonmonotonic_steps; default false
//   jacobi_scaling         default true
//   gradient_tolerance     default 1e-10
//   parameter_tolerance    default 1e-8
//   threads                default 1
// Options::cost_tolerance is Ceres' function_tolerance. Initialization kAuto is kKeep.
class CeresOptimizer : public backend::Optimizer {
 public:
  backend::Summary Optimize(const backend::Options& options, std::span<const backend::Edge> edges,
                            std::span<backend::Node> nodes) override;
};

}  // namespace gmapping_spa::ceres_backend

#endif  // GMAPPING_SPA_PLUGINS_CERES_CERES_OPTIMIZER_H_
