// SPDX-License-Identifier: BSD-3-Clause
// Levenberg-Marquardt that is Gauss-Newton wherever that works.
#ifndef GMAPPING_SPA_BACKEND_SPA_LEVENBERG_MARQUARDT_H_
#define GMAPPING_SPA_BACKEND_SPA_LEVENBERG_MARQUARDT_H_

#include <chrono>
#include <optional>
#include <vector>

#include "backend/cost/graph_cost.h"
#include "backend/plugin/optimizer.h"
#include "backend/spa/damped_solver.h"

namespace gmapping_spa::spa {

// What is minimized: the cost of a graph under a loss, over the poses of its free nodes.
struct GraphProblem {
  backend::PoseGraphView graph;
  const GraphStructure& structure;
  backend::Loss loss;

  // Makes the normal equations at `poses`.
  void LinearizeAt(const std::vector<backend::SE2>& poses, SolverMemory* memory) const {
    Linearize(graph, structure.index(), structure.blocks(), poses, loss, &memory->equations);
  }

  double CostAt(const std::vector<backend::SE2>& poses) const {
    return backend::GraphCost(graph, structure.index(), poses, loss);
  }
};

// The damping is zero until a step fails, steps may raise the cost for a while, and the damping is
// kept from one call to the next.
class LevenbergMarquardt {
 public:
  struct Options {
    int max_iterations = 100;      // those already in the summary included
    double cost_tolerance = 1e-7;  // see backend::Options
    LinearSolver solver = LinearSolver::kBlock;
    double first_damping = 0.0;      // lambda of eq. (5) before the first failure
    int max_nonmonotonic_steps = 2;  // in succession, before damping starts
    bool give_up_early = false;      // return where damping would have to start
    // When to return the best poses so far.
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  };

  // Lowers the cost from `*poses`, where the normal equations in `*memory` are, on; the poses end
  // as the best ones met, the equations anywhere. Fills in all of `*summary` but the initial cost;
  // the iterations are added to those there. Returns false when it gave up early.
  bool Minimize(const Options& options, const GraphProblem& problem, SolverMemory* memory,
                std::vector<backend::SE2>* poses, backend::Summary* summary);

  // What is kept from one call to the next.
  std::optional<double> damping() const { return damping_; }
  void set_damping(std::optional<double> damping) { damping_ = damping; }

  // To be called when the structure is another one than in the last call.
  void ForgetStructure() { solver_.ForgetStructure(); }

 private:
  DampedSolver solver_;
  std::optional<double> damping_;  // unset before the first call
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPA_LEVENBERG_MARQUARDT_H_
