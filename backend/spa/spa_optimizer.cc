// SPDX-License-Identifier: BSD-3-Clause
#include "backend/spa/spa_optimizer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "backend/packet.h"
#include "backend/sparse/graph_covariance.h"

namespace gmapping_spa::spa {
namespace {

using backend::Options;
using backend::PoseGraphView;
using backend::SE2;
using backend::Summary;

// Steps that may miss the lowest cost on the way from a coarse start.
constexpr int kManyNonmonotonicSteps = 20;

// How many times the last result's cost given poses may have and still pass for its continuation.
constexpr double kContinuationCostRatio = 2.0;

LevenbergMarquardt::Options MinimizerOptions(const Options& options) {
  const backend::Settings settings(SpaOptimizer::kSettings, options.settings);
  LevenbergMarquardt::Options minimizer;
  minimizer.max_iterations = options.max_iterations;
  minimizer.cost_tolerance = options.cost_tolerance;
  minimizer.solver =
      settings.Choice("solver") == "cholmod" ? LinearSolver::kCholmod : LinearSolver::kBlock;
  minimizer.first_damping = settings.Number("damping");
  minimizer.max_nonmonotonic_steps = settings.Integer("max_nonmonotonic_steps");
  minimizer.deadline = backend::DeadlineOf(options);
  return minimizer;
}

}  // namespace

std::vector<SE2> SpaOptimizer::CheaperStart(const GraphProblem& problem, double given_cost) {
  std::vector<SE2> start = PosesOf(problem.graph);
  if (InitializeChordal(problem.graph, structure_, &memory_, &start)) {
    problem.LinearizeAt(start, &memory_);
    if (memory_.equations.cost < given_cost) return start;
  }
  start = PosesOf(problem.graph);
  problem.LinearizeAt(start, &memory_);
  return start;
}

bool SpaOptimizer::StepContinues(LevenbergMarquardt::Options options, const GraphProblem& problem,
                                 std::vector<SE2>* poses, Summary* summary) {
  const int max_iterations = options.max_iterations;
  options.max_iterations = std::min(1, max_iterations);
  options.give_up_early = true;
  const std::optional<double> damping = minimizer_.damping();
  std::vector<SE2> stepped = *poses;
  Summary first = *summary;
  if (!minimizer_.Minimize(options, problem, &memory_, &stepped, &first) ||
      first.final_cost > kContinuationCostRatio * last_cost_) {
    minimizer_.set_damping(damping);
    return false;
  }
  *poses = std::move(stepped);
  *summary = std::move(first);
  if (max_iterations > 1) problem.LinearizeAt(*poses, &memory_);
  return true;
}

void SpaOptimizer::TryAnotherStart(LevenbergMarquardt::Options options, const GraphProblem& problem,
                                   std::vector<SE2>* poses, Summary* summary) {
  std::vector<SE2> other = PosesOf(problem.graph);
  if (InitializeChordalJointly(problem.graph, structure_, &memory_, &other)) {
    problem.LinearizeAt(other, &memory_);
    LevenbergMarquardt::Options nonmonotonic = options;
    nonmonotonic.max_nonmonotonic_steps =
        std::max(options.max_nonmonotonic_steps, kManyNonmonotonicSteps);
    Summary second = *summary;
    const bool finished = minimizer_.Minimize(nonmonotonic, problem, &memory_, &other, &second);
    summary->iterations = second.iterations;
    if (second.final_cost < summary->final_cost) {
      *poses = std::move(other);
      *summary = std::move(second);
      if (finished) return;
    }
  }
  problem.LinearizeAt(*poses, &memory_);
  options.give_up_early = false;
  minimizer_.Minimize(options, problem, &memory_, poses, summary);
}

void SpaOptimizer::CheckOptions(const Options& options) const {
  backend::Settings(kSettings, options.settings);
}

Summary SpaOptimizer::Optimize(const Options& options, std::span<const backend::Edge> edges,
                               std::span<backend::Node> nodes) {
  LevenbergMarquardt::Options minimizer_options = MinimizerOptions(options);
  const PoseGraphView graph{nodes, edges};
  structure_.Update(backend::IndexGraph(graph));
  if (structure_.changed()) minimizer_.ForgetStructure();
  memory_.cholesky.set_threads(backend::Settings(kSettings, options.settings).Integer("threads"));

  const GraphProblem problem{graph, structure_, options.loss};
  std::vector<SE2> poses = PosesOf(graph);
  const bool may_continue = backend::KeepsStart(options) || std::isfinite(last_cost_);
  Summary summary;
  if (may_continue) {
    problem.LinearizeAt(poses, &memory_);
    summary.initial_cost = memory_.equations.cost;
  } else {
    summary.initial_cost = problem.CostAt(poses);
  }
  summary.final_cost = summary.initial_cost;
  if (!std::isfinite(summary.initial_cost)) {
    summary.message = "the cost of the given poses is not finite";
    return summary;
  }
  const bool continues = summary.initial_cost <= kContinuationCostRatio * last_cost_;
  const bool choose_start = !backend::KeepsStart(options) && !continues;
  const bool stepped =
      choose_start && may_continue && StepContinues(minimizer_options, problem, &poses, &summary);
  if (choose_start && !stepped) poses = CheaperStart(problem, summary.initial_cost);
  minimizer_options.give_up_early = choose_start;
  const bool is_done = stepped && options.max_iterations == 1;
  if (!is_done && !minimizer_.Minimize(minimizer_options, problem, &memory_, &poses, &summary)) {
    TryAnotherStart(minimizer_options, problem, &poses, &summary);
  }
  if (summary.final_cost < summary.initial_cost) {
    for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k].world_T_node = poses[k];
  } else {
    summary.final_cost = summary.initial_cost;
  }
  last_cost_ = summary.final_cost;
  return summary;
}

std::vector<Eigen::Matrix3d> SpaOptimizer::Covariances(std::span<const backend::Edge> edges,
                                                       std::span<const backend::Node> nodes,
                                                       std::span<const backend::EdgeNodes> pairs) {
  const PoseGraphView graph{nodes, edges};
  structure_.Update(backend::IndexGraph(graph));
  if (structure_.changed()) minimizer_.ForgetStructure();
  auto covariances =
      CovariancesOf(graph, pairs, structure_, &memory_.equations, &memory_.cholesky.by_rows());
  if (!covariances) throw backend::NoCovariances();
  return *std::move(covariances);
}

std::optional<std::string> SpaOptimizer::State() const {
  backend::PacketWriter state;
  structure_.Save(&state);
  state.Put(minimizer_.damping().has_value());
  state.Put(minimizer_.damping().value_or(0.0));
  state.Put(last_cost_);
  return std::string(state.bytes().begin(), state.bytes().end());
}

void SpaOptimizer::SetState(const std::string& state) {
  backend::PacketReader reader(state);
  try {
    structure_.Load(&reader);
    const bool has_damping = reader.Take<std::uint8_t>() != 0;
    const auto damping = reader.Take<double>();
    minimizer_.set_damping(has_damping ? std::optional(damping) : std::nullopt);
    last_cost_ = reader.Take<double>();
    reader.CheckEnd();
  } catch (const backend::MalformedPacket&) {
    Optimizer::SetState(state);  // refuses it
  }
}

}  // namespace gmapping_spa::spa
