// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/robust_optimization.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "backend/cost/closure_mixture.h"
#include "backend/cost/graph_cost.h"
#include "backend/graph/graph_index.h"
#include "backend/scheduling/optimize_safely.h"

namespace gmapping_spa::backend {
namespace {

// Scale of dynamic covariance scaling: the 0.999 quantile of the errors of right closures (the root
// of that of the chi-square distribution with three degrees of freedom).
constexpr double kDcsScale = 4.033;
// Of the time that an optimization may take: least squares is in vain where closures are wrong.
constexpr double kFirstPartOfTime = 0.3;
// Iterations after which least squares is looked at: it takes many where closures are wrong.
constexpr int kFirstIterations = 15;
// Errors, as a multiple of what chance makes them, from which on more iterations are in vain.
constexpr double kHopeless = 20.0;
// Scaling only has to come near the truth.
constexpr double kScalingTolerance = 1e-4;
constexpr int kMaxRounds = 20;  // of sorting closures and least squares; a few are usual

PoseGraph CopyOf(const PoseGraphView& graph) {
  return {.nodes = {graph.nodes.begin(), graph.nodes.end()},
          .edges = {graph.edges.begin(), graph.edges.end()}};
}

void SetPoses(const std::vector<SE2>& poses, PoseGraph* graph) {
  for (std::size_t k = 0; k < poses.size(); ++k) graph->nodes[k].world_T_node = poses[k];
}

// The part of squared errors of right loop closures that are larger: the chi-square distribution
// with three degrees of freedom.
double PartAbove(double squared_error) {
  return std::erfc(std::sqrt(squared_error / 2.0)) +
         std::sqrt(2.0 * squared_error / std::numbers::pi) * std::exp(-squared_error / 2.0);
}

// The 0.99 quantile of the chi-square distribution (Wilson and Hilferty 1931).
double Quantile99(double degrees_of_freedom) {
  const double variance = 2.0 / (9.0 * degrees_of_freedom);
  return degrees_of_freedom * std::pow(1.0 - variance + 2.326 * std::sqrt(variance), 3.0);
}

// How large chance makes the sum of all squared errors where every edge is right.
double LargestSumByChance(const PoseGraphView& graph, const GraphIndex& index) {
  constexpr double kMisjudged = 1.1;  // covariances that are a little too small are no outliers
  const auto unknowns = static_cast<double>(std::ranges::count(index.fixed, false));
  const double degrees_of_freedom = 3.0 * (static_cast<double>(graph.edges.size()) - unknowns);
  return kMisjudged * Quantile99(std::max(degrees_of_freedom, 1.0));
}

// Whether least squares explains the graph: the largest error of all loop closures is no larger
// than chance makes it, and neither is the sum of all errors. A long way bends so easily that a
// wrong closure hardly shows in its own error.
bool EveryClosureAgrees(const PoseGraphView& graph, const GraphIndex& index,
                        const std::vector<SE2>& poses) {
  constexpr double kSignificance = 0.01;
  const std::vector<double> squared = SquaredErrors(graph, index, poses);
  double largest = 0.0, closures = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < squared.size(); ++k) {
    sum += squared[k];
    if (graph.edges[k].kind != EdgeKind::kLoopClosure) continue;
    largest = std::max(largest, squared[k]);
    closures += 1.0;
  }
  if (closures == 0.0) return true;
  return closures * PartAbove(largest) >= kSignificance && sum <= LargestSumByChance(graph, index);
}

// Poses with the mixture that explains the errors there, and how the optimizer came to them: what
// becomes of other starts does not concern them.
struct Explanation {
  std::vector<SE2> poses;
  ClosureMixture mixture;
  Termination termination = Termination::kNoConvergence;
  std::string message = "loop closures still changed sides";
};

// The optimizer with the graph and what is left of the time.
class RobustOptimization {
 public:
  RobustOptimization(const Options& options, Optimizer* optimizer, const PoseGraphView& graph)
      : options_(options),
        optimizer_(optimizer),
        graph_(graph),
        index_(IndexGraph(graph)),
        deadline_(DeadlineOf(options)) {
    options_.loss = {};
  }

  const GraphIndex& index() const { return index_; }
  Summary* summary() { return &summary_; }

  // Optimizes `graph` as one stage of all, in at most that part of the time that is left.
  bool Optimize(Initialization initialization, const Loss& loss, PoseGraph* graph,
                double part_of_time = 1.0, int iterations = std::numeric_limits<int>::max()) {
    Options stage = options_;
    stage.initialization = initialization;
    stage.loss = loss;
    stage.max_iterations = std::min(stage.max_iterations, iterations);
    if (loss.kind != LossKind::kNone) {
      stage.cost_tolerance = std::max(stage.cost_tolerance, kScalingTolerance);
    }
    if (deadline_ != std::chrono::steady_clock::time_point::max()) {
      const std::chrono::duration<double> left = deadline_ - std::chrono::steady_clock::now();
      stage.max_solver_time_s = std::max(0.0, part_of_time * left.count());
    }
    Summary result = OptimizeSafely(stage, optimizer_, graph);
    result.iterations.insert(result.iterations.begin(), summary_.iterations.begin(),
                             summary_.iterations.end());
    summary_ = std::move(result);
    return summary_.termination != Termination::kFailure;
  }

  Explanation Explain(std::vector<SE2> poses) const {
    ClosureMixture mixture = FitClosureMixture(graph_, index_, poses);
    return {.poses = std::move(poses), .mixture = std::move(mixture)};
  }

  // Steps 2 and 3. Returns nothing when the optimizer fails.
  std::optional<Explanation> Refine(std::vector<SE2> poses) {
    Explanation now = Explain(std::move(poses));
    for (int round = 0; round < kMaxRounds; ++round) {
      PoseGraph accepted = Accepted(now);
      if (!Optimize(Initialization::kKeep, {}, &accepted)) return std::nullopt;
      Explanation next = Explain(PosesOf(accepted));
      const bool settled = SameSides(now.mixture, next.mixture);
      now = std::move(next);
      if (settled) {
        now.termination = summary_.termination;
        now.message = summary_.message;
        break;
      }
    }
    return now;
  }

  // Step 1. Returns nothing when the optimizer fails.
  std::optional<std::vector<SE2>> Scale(Initialization initialization) {
    PoseGraph graph = CopyOf(graph_);
    if (!Optimize(initialization, {LossKind::kDcs, kDcsScale}, &graph)) return std::nullopt;
    return PosesOf(graph);
  }

  // Least squares, given up where it cannot explain the graph. False when the optimizer fails.
  bool OptimizeLeastSquares(PoseGraph* graph) {
    if (!Optimize(options_.initialization, {}, graph, kFirstPartOfTime, kFirstIterations)) {
      return false;
    }
    const int left = options_.max_iterations - kFirstIterations;
    const double hopeless = kHopeless * LargestSumByChance(graph_, index_);
    if (summary_.termination == Termination::kConverged || left <= 0 ||
        2.0 * summary_.final_cost > hopeless) {
      return true;
    }
    return Optimize(Initialization::kKeep, {}, graph, kFirstPartOfTime, left);
  }

 private:
  // The graph without closures that are rather wrong than right.
  PoseGraph Accepted(const Explanation& explanation) const {
    const ClosureMixture& mixture = explanation.mixture;
    PoseGraph accepted{
        .nodes = {graph_.nodes.begin(), graph_.nodes.end()},
        .edges = AcceptedEdges(graph_.edges, mixture.inlier_probability, mixture.variance_factor)};
    SetPoses(explanation.poses, &accepted);
    return accepted;
  }

  static bool SameSides(const ClosureMixture& a, const ClosureMixture& b) {
    constexpr double kSameFactor = 1e-2;
    if (std::abs(a.variance_factor - b.variance_factor) > kSameFactor * a.variance_factor) {
      return false;
    }
    return std::ranges::equal(a.inlier_probability, b.inlier_probability,
                              [](double p, double q) { return (p < 0.5) == (q < 0.5); });
  }

  Options options_;
  Optimizer* optimizer_;
  PoseGraphView graph_;
  GraphIndex index_;
  std::chrono::steady_clock::time_point deadline_;
  Summary summary_;
};

bool IsBetter(const ClosureMixture& a, const ClosureMixture& b) {
  return a.negative_log_likelihood < b.negative_log_likelihood;
}

void KeepBetter(std::optional<Explanation> other, std::optional<Explanation>* best) {
  if (other && (!*best || IsBetter(other->mixture, (*best)->mixture))) *best = std::move(other);
}

}  // namespace

Summary OptimizeRobustly(const Options& options, Optimizer* optimizer, PoseGraph* graph) {
  const std::vector<Node> given_nodes = graph->nodes;
  const PoseGraphView given(given_nodes, graph->edges);
  RobustOptimization robust(options, optimizer, given);
  const GraphIndex& index = robust.index();
  if (!robust.OptimizeLeastSquares(graph)) return *robust.summary();
  const std::vector<SE2> least_squares = PosesOf(*graph);
  if (EveryClosureAgrees(given, index, least_squares)) {
    const bool ran_out_of_time = robust.summary()->termination == Termination::kNoConvergence &&
                                 std::isfinite(options.max_solver_time_s);
    if (ran_out_of_time && !robust.Optimize(Initialization::kKeep, {}, graph)) {
      robust.summary()->termination = Termination::kNoConvergence;
    }
    robust.summary()->initial_cost = GraphCost(given, index);
    robust.summary()->edge_weights.assign(given.edges.size(), 1.0);
    return *robust.summary();
  }

  std::optional<Explanation> best;
  const std::optional<std::vector<SE2>> scaled = robust.Scale(options.initialization);
  if (scaled) best = robust.Refine(*scaled);
  // Where it is up to us, the odometry is another start, unless the back end moves nothing at all.
  if (options.initialization == Initialization::kAuto && best && best->poses != PosesOf(given)) {
    const std::optional<std::vector<SE2>> from_odometry = robust.Scale(Initialization::kOdometry);
    if (from_odometry && from_odometry != scaled) {
      KeepBetter(robust.Refine(*from_odometry), &best);
    }
  }
  // Where few are wrong, least squares or the given poses may be nearer to the truth.
  for (const std::vector<SE2>& poses : {least_squares, PosesOf(given)}) {
    if (best && IsBetter(FitClosureMixture(given, index, poses), best->mixture)) {
      KeepBetter(robust.Refine(poses), &best);
    }
  }
  graph->nodes = given_nodes;
  Summary summary = *robust.summary();
  if (!best) {
    summary.initial_cost = summary.final_cost = GraphCost(given, index);
    return summary;
  }
  summary.termination = best->termination;
  summary.message = best->message;
  summary.initial_cost = MixtureCost(given, index, PosesOf(given), best->mixture);
  summary.final_cost = MixtureCost(given, index, best->poses, best->mixture);
  if (summary.final_cost > summary.initial_cost) {
    summary.message += "; the given poses cost less and are kept";
    summary.final_cost = summary.initial_cost;
    best = robust.Explain(PosesOf(given));
  }
  SetPoses(best->poses, graph);
  summary.edge_weights = best->mixture.inlier_probability;
  summary.variance_factor = best->mixture.variance_factor;
  return summary;
}

}  // namespace gmapping_spa::backend
