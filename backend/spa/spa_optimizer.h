// Sparse Pose Adjustment.
#ifndef GMAPPING_SPA_BACKEND_SPA_SPA_OPTIMIZER_H_
#define GMAPPING_SPA_BACKEND_SPA_SPA_OPTIMIZER_H_

#include <limits>
#include <optional>
#include <vector>

#include "backend/initialization/chordal_initialization.h"
#include "backend/plugin/optimizer.h"
#include "backend/sparse/cholmod_solver.h"
#include "backend/sparse/graph_structure.h"

namespace gmapping_spa::spa {

// Levenberg-Marquardt on the sparse normal equations (Konolige, Grisetti, Kuemmerle, Burgard,
// Limketkai, Vincent 2010, "Efficient Sparse Pose Adjustment for 2D Mapping"; eq. (5) of Tao et al.
// 2021), run as Gauss-Newton wherever that works: the damping is zero until a step fails, steps may
// raise the cost for a while, and the damping is kept from one call to the next.
//
// Settings:
//   solver      block (default: our Cholesky factorization of 3x3 blocks) or cholmod
//   damping     lambda of eq. (5) in the first iteration; default 0
//   max_nonmonotonic_steps   steps in succession without a new lowest cost before damping starts;
//   default 2
//
// Initialization kAuto keeps given poses that cost about what the result of the call before did, as
// in the online case; else it starts from the cheaper one of the given poses and the chordal
// relaxation, and where Gauss-Newton fails there, from the joint chordal relaxation too.
class SpaOptimizer : public backend::Optimizer {
 public:
  backend::Summary Optimize(const backend::Options& options, std::span<const backend::Edge> edges,
                            std::span<backend::Node> nodes) override;

 private:
  struct Settings {
    bool cholmod;
    double damping;
    int max_nonmonotonic_steps;
  };
  static Settings ReadSettings(const backend::Options& options);

  backend::Summary OptimizeOrThrow(const backend::Options& options,
                                   std::span<const backend::Edge> edges,
                                   std::span<backend::Node> nodes);

  // Makes the normal equations at `poses`.
  void LinearizeAt(const backend::Options& options, const backend::PoseGraphView& graph,
                   const std::vector<backend::SE2>& poses);

  // Where the minimization starts; the normal equations are those there.
  std::vector<backend::SE2> ChooseStart(const backend::Options& options,
                                        const backend::PoseGraphView& graph, double given_cost);

  // Lowers the cost from `*poses`, where the normal equations are, on; they end as the best ones
  // met. Fills in all of `summary` but the initial cost; the iterations are added to those there.
  // With `give_up_early`, returns false where damping would have to start.
  bool Minimize(const backend::Options& options, const Settings& settings,
                const backend::PoseGraphView& graph, bool give_up_early,
                std::vector<backend::SE2>* poses, backend::Summary* summary);

  // After Minimize gave up: tries another start, then goes on from the better one's end.
  void TryAnotherStart(const backend::Options& options, const Settings& settings,
                       const backend::PoseGraphView& graph, std::vector<backend::SE2>* poses,
                       backend::Summary* summary);

  // Solves eq. (5), (H + lambda diag(H)) dx = -g. False when the matrix is not positive definite.
  bool SolveStep(double lambda, bool cholmod, std::vector<BlockVector<3>>* step);

  GraphStructure structure_;
  SolverMemory memory_;
  BlockMatrix damped_;  // memory of SolveStep
  CholmodSolver cholmod_;
  bool cholmod_knows_structure_ = false;
  std::optional<double> damping_;  // unset before the first call
  double last_cost_ = -std::numeric_limits<double>::infinity();
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPA_SPA_OPTIMIZER_H_
