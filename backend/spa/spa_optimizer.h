// SPDX-License-Identifier: BSD-3-Clause
// Sparse Pose Adjustment.
#ifndef GMAPPING_SPA_BACKEND_SPA_SPA_OPTIMIZER_H_
#define GMAPPING_SPA_BACKEND_SPA_SPA_OPTIMIZER_H_

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "backend/plugin/optimizer.h"
#include "backend/plugin/settings.h"
#include "backend/spa/levenberg_marquardt.h"

namespace gmapping_spa::spa {

// Levenberg-Marquardt on the sparse normal equations (Konolige, Grisetti, Kuemmerle, Burgard,
// Limketkai, Vincent 2010, "Efficient Sparse Pose Adjustment for 2D Mapping"; eq. (5) of Tao et al.
// 2021): this class chooses where to start, and remembers what the call before came to.
//
// Initialization kAuto keeps given poses that cost about what the result of the call before did, as
// in the online case; else it starts from the cheaper one of the given poses and the chordal
// relaxation, and where Gauss-Newton fails there, from the joint chordal relaxation too.
class SpaOptimizer : public backend::Optimizer {
 public:
  static constexpr backend::SettingDescription kSettings[] = {
      backend::ChoiceSetting("solver", "block", GMAPPING_SPA_CHOLMOD ? "block,cholmod" : "block",
                             "linear solver: block is this project's Cholesky factorization of 3x3 "
                             "blocks, cholmod is SuiteSparse's CHOLMOD"),
      backend::NumberSetting("damping", "0",
                             "lambda of eq. (5) in the first iteration; 0 is Gauss-Newton", 0.0),
      backend::IntegerSetting("max_nonmonotonic_steps", "2",
                              "steps in succession without a new lowest cost before damping starts",
                              0),
      backend::IntegerSetting("threads", "1",
                              "threads that may factorize a large graph, some ten thousand poses "
                              "or more; the result does not depend on it",
                              1, 1024)};
  static constexpr backend::LossKind kLosses[] = {
      backend::LossKind::kHuber, backend::LossKind::kCauchy, backend::LossKind::kDcs,
      backend::LossKind::kTruncated};

  void CheckOptions(const backend::Options& options) const override;
  backend::Summary Optimize(const backend::Options& options, std::span<const backend::Edge> edges,
                            std::span<backend::Node> nodes) override;
  // On the ordering and the symbolic factor of the last graph, if it is the same.
  bool HasCovariances() const override { return true; }
  std::vector<Eigen::Matrix3d> Covariances(std::span<const backend::Edge> edges,
                                           std::span<const backend::Node> nodes,
                                           std::span<const backend::EdgeNodes> pairs) override;
  // The ordering of the last graph, its cost and the damping there: what the next call goes on
  // from.
  std::optional<std::string> State() const override;
  void SetState(const std::string& state) override;

 private:
  // The cheaper one of the given poses, which cost given_cost, and the chordal relaxation; the
  // normal equations are those there.
  std::vector<backend::SE2> CheaperStart(const GraphProblem& problem, double given_cost);

  // Takes a step from the given poses, where the normal equations are. True when that brings the
  // cost to about that of the call before, as it mostly does when a loop was closed, for less than
  // another start costs; else everything is as before but the normal equations.
  bool StepContinues(LevenbergMarquardt::Options options, const GraphProblem& problem,
                     std::vector<backend::SE2>* poses, backend::Summary* summary);

  // After Minimize gave up: tries another start, then goes on from the better one's end.
  void TryAnotherStart(LevenbergMarquardt::Options options, const GraphProblem& problem,
                       std::vector<backend::SE2>* poses, backend::Summary* summary);

  GraphStructure structure_;
  SolverMemory memory_;
  LevenbergMarquardt minimizer_;
  double last_cost_ = -std::numeric_limits<double>::infinity();
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPA_SPA_OPTIMIZER_H_
