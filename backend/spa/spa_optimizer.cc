#include "backend/spa/spa_optimizer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include "backend/cost/graph_cost.h"
#include "backend/initialization/initial_guess.h"
#include "backend/plugin/settings.h"

namespace gmapping_spa::spa {
namespace {

using backend::Initialization;
using backend::Options;
using backend::PoseGraphView;
using backend::SE2;
using backend::Summary;
using backend::Termination;

// Damping below this is none; the first damped step has kFirstDamping; more than kLastDamping means
// that no step, however short, lowers the cost.
constexpr double kLeastDamping = 1e-7;
constexpr double kFirstDamping = 1e-4;
constexpr double kLastDamping = 1e10;
constexpr double kDampingFactor = 10.0;

// From where on, as a fraction of the cost, a Gauss-Newton step may be the last one.
constexpr double kLastStepDecrease = 1e-2;

// Steps that may miss the lowest cost on the way from a coarse start.
constexpr int kManyNonmonotonicSteps = 20;

// How many times the last result's cost given poses may have and still pass for its continuation.
constexpr double kContinuationCostRatio = 2.0;

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void AddStep(const BlockStructure& structure, const std::vector<BlockVector<3>>& step,
             std::vector<SE2>* poses) {
  for (int k = 0; k < structure.columns(); ++k) {
    SE2& pose = (*poses)[structure.node_of_column[k]];
    pose.x += step[k].x();
    pose.y += step[k].y();
    pose.theta = backend::WrapAngle(pose.theta + step[k].z());
  }
}

double SquaredNorm(const std::vector<BlockVector<3>>& step) {
  double sum = 0.0;
  for (const BlockVector<3>& block : step) sum += block.squaredNorm();
  return sum;
}

// By how much the step lowers the quadratic model of the cost: dx' (-g + lambda diag(H) dx) / 2.
double PredictedDecrease(const NormalEquations& equations, double lambda,
                         const std::vector<BlockVector<3>>& step) {
  double decrease = 0.0;
  for (std::size_t k = 0; k < step.size(); ++k) {
    const BlockVector<3> damped =
        lambda *
        equations.hessian.diagonal<3>(static_cast<int>(k)).diagonal().cwiseProduct(step[k]);
    decrease += 0.5 * step[k].dot(equations.minus_gradient[k] + damped);
  }
  return decrease;
}

double Raised(double damping) { return std::max(kFirstDamping, damping * kDampingFactor); }

double Lowered(double damping) {
  return damping / kDampingFactor < kLeastDamping ? 0.0 : damping / kDampingFactor;
}

}  // namespace

SpaOptimizer::Settings SpaOptimizer::ReadSettings(const Options& options) {
  backend::SettingsReader reader(options.settings);
  Settings settings{};
  settings.cholmod = reader.Choice("solver", {"block", "cholmod"}) == "cholmod";
  settings.damping = reader.Number("damping", 0.0, 0.0);
  settings.max_nonmonotonic_steps = reader.Integer("max_nonmonotonic_steps", 2, 0);
  reader.RejectOthers();
  return settings;
}

void SpaOptimizer::LinearizeAt(const Options& options, const PoseGraphView& graph,
                               const std::vector<SE2>& poses) {
  Linearize(graph, structure_.index(), structure_.blocks(), poses, options.loss,
            &memory_.equations);
}

std::vector<SE2> SpaOptimizer::ChooseStart(const Options& options, const PoseGraphView& graph,
                                           double given_cost) {
  std::vector<SE2> start = PosesOf(graph);
  bool only_if_cheaper = false;
  switch (options.initialization) {
    case Initialization::kKeep:
      break;
    case Initialization::kOdometry:
      backend::InitializeFromOdometry(graph, structure_.index(), &start);
      break;
    case Initialization::kSpanningTree:
      backend::InitializeFromSpanningTree(graph, structure_.index(), &start);
      break;
    case Initialization::kAuto:
      if (given_cost <= kContinuationCostRatio * last_cost_) break;
      only_if_cheaper = true;
      [[fallthrough]];
    case Initialization::kChordal:
      if (!InitializeChordal(graph, structure_, &memory_, &start)) start = PosesOf(graph);
      break;
  }
  LinearizeAt(options, graph, start);
  if (only_if_cheaper && !(memory_.equations.cost < given_cost)) {
    start = PosesOf(graph);
    LinearizeAt(options, graph, start);
  }
  return start;
}

bool SpaOptimizer::SolveStep(double lambda, bool cholmod, std::vector<BlockVector<3>>* step) {
  const BlockMatrix* hessian = &memory_.equations.hessian;
  if (lambda > 0.0) {
    damped_ = *hessian;
    for (int k = 0; k < structure_.blocks().columns(); ++k) {
      Eigen::Map<Block<3>> block = damped_.diagonal<3>(k);
      // Coordinates that no measurement sees are held by the damping alone.
      for (int c = 0; c < 3; ++c) block(c, c) += lambda * (block(c, c) > 0.0 ? block(c, c) : 1.0);
    }
    hessian = &damped_;
  }
  *step = memory_.equations.minus_gradient;
  if (cholmod) {
    return cholmod_.Solve(structure_.blocks(), *hessian,
                          !std::exchange(cholmod_knows_structure_, true), step);
  }
  return memory_.cholesky.Solve(structure_.blocks(), structure_.symbolic(), *hessian, step);
}

bool SpaOptimizer::Minimize(const Options& options, const Settings& settings,
                            const PoseGraphView& graph, bool give_up_early, std::vector<SE2>* poses,
                            Summary* summary) {
  double damping = damping_.value_or(settings.damping);
  int nonmonotonic_steps = 0;
  std::vector<SE2> current = *poses;
  std::vector<BlockVector<3>> step;
  summary->final_cost = memory_.equations.cost;
  summary->termination = Termination::kNoConvergence;
  summary->message = "ran out of iterations";
  while (static_cast<int>(summary->iterations.size()) < options.max_iterations) {
    const auto iteration_start = std::chrono::steady_clock::now();
    const bool solved = SolveStep(damping, settings.cholmod, &step);
    backend::IterationRecord record;
    record.cost = summary->final_cost;
    record.damping = damping;
    record.linear_solver_s = SecondsSince(iteration_start);

    bool improved = false, converged = false;
    const double tolerance = options.cost_tolerance * summary->final_cost;
    if (solved) {
      record.step_norm = std::sqrt(SquaredNorm(step));
      const double predicted = PredictedDecrease(memory_.equations, damping, step);
      AddStep(structure_.blocks(), step, &current);
      if (damping <= kFirstDamping && predicted <= kLastStepDecrease * summary->final_cost) {
        // Near the minimum, the next Gauss-Newton step gains no more than the quadratic model was
        // wrong by.
        record.cost = backend::GraphCost(graph, structure_.index(), current, options.loss);
        const double model_error = memory_.equations.cost - predicted - record.cost;
        const bool next_gains_little = damping == 0.0 && std::abs(model_error) <= tolerance;
        converged = (predicted <= tolerance || next_gains_little) &&
                    record.cost <= summary->final_cost + tolerance;
      }
      if (!converged) {
        LinearizeAt(options, graph, current);
        record.cost = memory_.equations.cost;
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
               nonmonotonic_steps < settings.max_nonmonotonic_steps) {
      // Gauss-Newton often leaves a poor start over a hill; let it.
      ++nonmonotonic_steps;
    } else {
      if (give_up_early && damping == 0.0) {
        record.total_s = SecondsSince(iteration_start);
        summary->iterations.push_back(record);
        return false;
      }
      damping = Raised(damping);
      nonmonotonic_steps = 0;
      if (solved) {
        current = *poses;
        LinearizeAt(options, graph, current);
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
  damping_ = damping > kLastDamping ? settings.damping
                                    : (nonmonotonic_steps > 0 ? Raised(damping) : damping);
  return true;
}

void SpaOptimizer::TryAnotherStart(const Options& options, const Settings& settings,
                                   const PoseGraphView& graph, std::vector<SE2>* poses,
                                   Summary* summary) {
  std::vector<SE2> other = PosesOf(graph);
  if (InitializeChordalJointly(graph, structure_, &memory_, &other)) {
    LinearizeAt(options, graph, other);
    Settings nonmonotonic = settings;
    nonmonotonic.max_nonmonotonic_steps =
        std::max(settings.max_nonmonotonic_steps, kManyNonmonotonicSteps);
    Summary second = *summary;
    const bool finished =
        Minimize(options, nonmonotonic, graph, /*give_up_early=*/true, &other, &second);
    summary->iterations = second.iterations;
    if (second.final_cost < summary->final_cost) {
      *poses = std::move(other);
      *summary = std::move(second);
      if (finished) return;
    }
  }
  LinearizeAt(options, graph, *poses);
  Minimize(options, settings, graph, /*give_up_early=*/false, poses, summary);
}

Summary SpaOptimizer::OptimizeOrThrow(const Options& options, std::span<const backend::Edge> edges,
                                      std::span<backend::Node> nodes) {
  const Settings settings = ReadSettings(options);
  const PoseGraphView graph{nodes, edges};
  structure_.Update(backend::IndexGraph(graph));
  if (structure_.changed()) cholmod_knows_structure_ = false;

  Summary summary;
  summary.initial_cost = backend::GraphCost(graph, structure_.index(), options.loss);
  summary.final_cost = summary.initial_cost;
  if (!std::isfinite(summary.initial_cost)) {
    summary.message = "the cost of the given poses is not finite";
    return summary;
  }
  // Neither told where to start nor continuing.
  const bool fresh = options.initialization == Initialization::kAuto &&
                     !(summary.initial_cost <= kContinuationCostRatio * last_cost_);
  std::vector<SE2> poses = ChooseStart(options, graph, summary.initial_cost);
  if (!Minimize(options, settings, graph, /*give_up_early=*/fresh, &poses, &summary)) {
    TryAnotherStart(options, settings, graph, &poses, &summary);
  }
  if (summary.final_cost < summary.initial_cost) {
    for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k].world_T_node = poses[k];
  } else {
    summary.final_cost = summary.initial_cost;
  }
  last_cost_ = summary.final_cost;
  return summary;
}

Summary SpaOptimizer::Optimize(const Options& options, std::span<const backend::Edge> edges,
                               std::span<backend::Node> nodes) {
  try {
    return OptimizeOrThrow(options, edges, nodes);
  } catch (const std::exception& error) {
    Summary summary;
    summary.message = error.what();
    return summary;
  }
}

}  // namespace gmapping_spa::spa
