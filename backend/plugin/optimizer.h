// SPDX-License-Identifier: BSD-3-Clause
// The back end interface: what improves the poses of a graph.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_H_

#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "backend/cost/robust_loss.h"
#include "backend/graph/graph_index.h"
#include "backend/graph/pose_graph.h"
#include "backend/initialization/initialization.h"

namespace gmapping_spa::backend {

struct Options {
  int max_iterations = 100;
  // Where to start. OptimizeSafely sees to all but kAuto, the back end's own choice: an optimizer
  // is told that or kKeep.
  Initialization initialization = Initialization::kAuto;
  // Converged when the linearised problem promises to lower the cost by less than this fraction.
  double cost_tolerance = 1e-7;
  // An optimizer that takes longer returns the best poses so far. Results then depend on the
  // machine.
  double max_solver_time_s = std::numeric_limits<double>::infinity();
  Loss loss;  // of loop closures
  // A back end's own options by name; `optimize_graph --list_backends` lists them.
  std::map<std::string, std::string> settings;
  friend bool operator==(const Options&, const Options&) = default;
};

struct IterationRecord {
  double cost = 0.0;             // after the step
  double step_norm = 0.0;        // of all poses, in the mixed units m and rad
  double damping = 0.0;          // lambda of eq. (5); 0 is Gauss-Newton
  double linear_solver_s = 0.0;  // factorization and substitution
  double total_s = 0.0;
};

enum class Termination : std::uint8_t {
  kConverged,
  kNoConvergence,  // out of iterations or time
  kFailure         // the poses are as they were
};

struct Summary {
  Termination termination = Termination::kFailure;
  std::string message;        // one line, why it ended
  double initial_cost = 0.0;  // of the poses that were given
  double final_cost = 0.0;    // of the poses that are returned
  std::vector<IterationRecord> iterations;
  // Of Optimize (scheduling/optimize.h), not of a back end: for each edge, the inlier probability
  // under LossKind::kMixture, the loss's weight else. An edge below 1/2 is rejected.
  std::vector<double> edge_weights;
  double variance_factor = 1.0;  // see ClosureMixture
};

// An optimizer may keep state between calls, such as an ordering or a symbolic factorization; it
// notices when the graph has changed. Use one object in one thread at a time.
class Optimizer {
 public:
  virtual ~Optimizer() = default;
  // Throws std::runtime_error with one line when it cannot do what the options ask for: a setting
  // that it does not have, or that has no such value, or a loss that it does not support.
  virtual void CheckOptions(const Options& /*options*/) const {}
  // Improves the poses of `nodes` and changes nothing else of them. Poses are finite before and
  // after; never do those after cost more (GraphCost under options.loss). Leaves fixed nodes where
  // they are, and the first node of each connected component that has none. May throw: callers
  // (OptimizeSafely) and the boundary of plugins make a failure of it.
  virtual Summary Optimize(const Options& options, std::span<const Edge> edges,
                           std::span<Node> nodes) = 0;

  // An ability that an optimizer may have: Covariances. Where it has not, programs compute them
  // from the graph (scheduling/covariances.h).
  virtual bool HasCovariances() const { return false; }
  // For each pair of nodes (positions), the covariance between the pose (x, y, theta) of i, rows,
  // and that of j, columns, at the given poses: those of least squares with all edges at their
  // information, blocks of the inverse of the Gauss-Newton Hessian of the nodes that are not held.
  // Coordinates are those that errors are added to (Plus): x and y along the axes of the world
  // frame, m and rad. Held nodes (see Optimize) have zero. Throws std::runtime_error with one line
  // when there are none: the edges do not determine all poses, or HasCovariances is false.
  virtual std::vector<Eigen::Matrix3d> Covariances(std::span<const Edge> edges,
                                                   std::span<const Node> nodes,
                                                   std::span<const EdgeNodes> pairs);

  // An ability that an optimizer may have: to go on in another process. State: the bytes of all
  // that later calls of Optimize depend on, empty where they depend on nothing; nothing where it
  // has not the ability. SetState makes those bytes the state of an optimizer that has not been
  // called; throws std::runtime_error with one line when they are no state.
  virtual std::optional<std::string> State() const { return std::nullopt; }
  virtual void SetState(const std::string& state);
};

// A back end that keeps nothing from one call to the next.
class StatelessOptimizer : public Optimizer {
 public:
  std::optional<std::string> State() const override { return std::string(); }
  void SetState(const std::string& state) override {
    if (!state.empty()) Optimizer::SetState(state);
  }
};

// For optimizers: whether to start from the given poses (kKeep) or from where they like (kAuto).
// Throws std::invalid_argument for other initializations: nobody has seen to them.
bool KeepsStart(const Options& options);

// For optimizers: the error that their Covariances throw where edges do not determine the poses.
std::runtime_error NoCovariances();

// For optimizers, at the begin of a call: when options.max_solver_time_s will be over.
std::chrono::steady_clock::time_point DeadlineOf(const Options& options);

// Name as used on command lines and in JSON: converged, no_convergence, failure.
const char* TerminationName(Termination termination);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_H_
