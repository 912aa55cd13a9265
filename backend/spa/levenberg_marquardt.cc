// SPDX-License-Identifier: BSD-3-Clause
#include "backend/spa/levenberg_marquardt.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gmapping_spa::spa {
namespace {

using backend::SE2;
using backend::Summary;
using backend::Termination;
using Clock = std::chrono::steady_clock;

// Damping below this is none; the first damped step has kFirstDamping; more than kLastDamping means
// that no step, however short, lowers the cost.
constexpr double kLeastDamping = 1e-7;
constexpr double kFirstDamping = 1e-4;
constexpr double kLastDamping = 1e10;
constexpr double kDampingFactor = 10.0;

// A Gauss-Newton step of at most this part of the poses is rounding. It ends the optimization of
// graphs whose edges agree, such as trees: a cost that is rounding itself has no smallest part.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();

// From where on, as a fraction of the cost, a Gauss-Newton step may be the last one.
constexpr double kLastStepDecrease = 1e-2;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void AddStep(const BlockStructure& structure, const PoseMatrix::Vector& step,
             std::vector<SE2>* poses) {
  for (int k = 0; k < structure.columns(); ++k) {
    SE2& pose = (*poses)[structure.node_of_column[k]];
    pose = Plus(pose, step[k]);
  }
}

double SquaredNorm(const PoseMatrix::Vector& step) {
  double sum = 0.0;
  for (const PoseMatrix::Segment& block : step) sum += block.squaredNorm();
  return sum;
}

// Of the free poses, in m and rad.
double NormOf(const BlockStructure& structure, const std::vector<SE2>& poses) {
  double sum = 0.0;
  for (const int node : structure.node_of_column) {
    const SE2& pose = poses[node];
    sum += pose.x * pose.x + pose.y * pose.y + pose.theta * pose.theta;
  }
  return std::sqrt(sum);
}

double Raised(double damping) { return std::max(kFirstDamping, damping * kDampingFactor); }

double Lowered(double damping) {
  return damping / kDampingFactor < kLeastDamping ? 0.0 : damping / kDampingFactor;
}

}  // namespace

bool LevenbergMarquardt::Minimize(const Options& options, const GraphProblem& problem,
                                  SolverMemory* memory, std::vector<SE2>* poses, Summary* summary) {
  double damping = damping_.value_or(options.first_damping);
  int nonmonotonic_steps = 0;
  std::vector<SE2> current = *poses;
  PoseMatrix::Vector step;
  summary->final_cost = memory->equations.cost;
  summary->termination = Termination::kNoConvergence;
  summary->message = "ran out of iterations";
  while (static_cast<int>(summary->iterations.size()) < options.max_iterations) {
    const auto iteration_start = Clock::now();
    if (iteration_start >= options.deadline) {
      summary->message = "ran out of time";
      break;
    }
    const bool is_last = static_cast<int>(summary->iterations.size()) + 1 == options.max_iterations;
    const bool solved = solver_.Solve(problem.structure, damping, options.solver, memory, &step);
    backend::IterationRecord record;
    record.cost = summary->final_cost;
    record.damping = damping;
    record.linear_solver_s = SecondsSince(iteration_start);

    bool improved = false, converged = false;
    const double tolerance = options.cost_tolerance * summary->final_cost;
    if (solved) {
      record.step_norm = std::sqrt(SquaredNorm(step));
      const double predicted = PredictedDecrease(memory->equations, damping, step);
      AddStep(problem.structure.blocks(), step, &current);
      if (damping == 0.0 &&
          record.step_norm <= kRounding * NormOf(problem.structure.blocks(), current)) {
        record.cost = problem.CostAt(current);
        converged = true;
      } else if (damping <= kFirstDamping && predicted <= kLastStepDecrease * summary->final_cost) {
        // Near the minimum, the next Gauss-Newton step gains no more than the quadratic model was
        // wrong by.
        record.cost = problem.CostAt(current);
        const double model_error = memory->equations.cost - predicted - record.cost;
        const bool next_gains_little = damping == 0.0 && std::abs(model_error) <= tolerance;
        converged = (predicted <= tolerance || next_gains_little) &&
                    record.cost <= summary->final_cost + tolerance;
      }
      if (!converged && is_last) {
        record.cost = problem.CostAt(current);
      } else if (!converged) {
        problem.LinearizeAt(current, memory);
        record.cost = memory->equations.cost;
      }
      improved = record.cost < summary->final_cost;
    }
    if (improved) {
      summary->final_cost = record.cost;
      *poses = current;
      damping = Lowered(damping);
      nonmonotonic_steps = 0;
    } else if (converged) {
      // The step is too short to tell; keep what there is.
    } else if (solved && damping == 0.0 && std::isfinite(record.cost) &&
               nonmonotonic_steps < options.max_nonmonotonic_steps) {
      // Gauss-Newton often leaves a poor start over a hill; let it.
      ++nonmonotonic_steps;
    } else {
      if (options.give_up_early && damping == 0.0) {
        record.total_s = SecondsSince(iteration_start);
        summary->iterations.push_back(record);
        return false;
      }
      damping = Raised(damping);
      nonmonotonic_steps = 0;
      if (solved && !is_last) {
        current = *poses;
        problem.LinearizeAt(current, memory);
      }
    }
    record.total_s = SecondsSince(iteration_start);
    summary->iterations.push_back(record);
    if (converged || damping > kLastDamping) {
      summary->termination = Termination::kConverged;
      summary->message = converged
                             ? "a further step would lower the cost by less than the tolerance"
                             : "no step lowers the cost";
      break;
    }
  }
  // Steps that only raised the cost are lost with the call, but not their lesson.
  damping_ = damping > kLastDamping ? options.first_damping
                                    : (nonmonotonic_steps > 0 ? Raised(damping) : damping);
  return true;
}

}  // namespace gmapping_spa::spa
