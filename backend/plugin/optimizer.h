// The back end interface: what improves the poses of a graph.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_H_

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "backend/cost/robust_loss.h"
#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// Where an optimizer starts.
enum class Initialization : std::uint8_t {
  kAuto,          // the optimizer's own choice
  kKeep,          // the given poses
  kOdometry,      // see InitializeFromOdometry
  kSpanningTree,  // see InitializeFromSpanningTree
  kChordal        // the chordal relaxation of Carlone et al. 2015
};

struct Options {
  int max_iterations = 100;
  Initialization initialization = Initialization::kAuto;
  // Converged when the linearised problem promises to lower the cost by less than this fraction.
  double cost_tolerance = 1e-7;
  Loss loss;  // of loop closures
  // A back end's own options by name; its documentation lists them. Unknown ones are failures.
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
  kNoConvergence,  // out of iterations
  kFailure         // the poses are as they were
};

struct Summary {
  Termination termination = Termination::kFailure;
  std::string message;        // one line, why it ended
  double initial_cost = 0.0;  // of the poses that were given
  double final_cost = 0.0;    // of the poses that are returned
  std::vector<IterationRecord> iterations;
};

// An optimizer may keep state between calls, such as an ordering or a symbolic factorization; it
// notices when the graph has changed. Use one object in one thread at a time.
class Optimizer {
 public:
  virtual ~Optimizer() = default;
  // Improves the poses of `nodes` and changes nothing else of them. Poses are finite before and
  // after; never do those after cost more (GraphCost under options.loss). Leaves fixed nodes where
  // they are, and the first node of each connected component that has none.
  virtual Summary Optimize(const Options& options, std::span<const Edge> edges,
                           std::span<Node> nodes) = 0;
};

// Names as used on command lines: auto, keep, odometry, spanning_tree, chordal; converged,
// no_convergence, failure. InitializationFromName throws std::runtime_error with one line.
const char* InitializationName(Initialization initialization);
Initialization InitializationFromName(const std::string& name);
const char* TerminationName(Termination termination);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_H_
