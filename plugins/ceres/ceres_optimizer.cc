// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/ceres/ceres_optimizer.h"

#include <ceres/covariance.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "backend/cost/graph_cost.h"
#include "backend/graph/graph_index.h"
#include "plugins/ceres/pose_problem.h"

namespace gmapping_spa::ceres_backend {
namespace {

using backend::Options;
using backend::PoseGraphView;
using backend::SE2;
using backend::Summary;
using backend::Termination;

::ceres::Solver::Options SolverOptions(const Options& options) {
  const backend::Settings settings(CeresOptimizer::kSettings, options.settings);
  ::ceres::Solver::Options solver;
  solver.logging_type = ::ceres::SILENT;
  solver.max_num_iterations = options.max_iterations;
  solver.function_tolerance = options.cost_tolerance;
  solver.max_solver_time_in_seconds =
      std::min(solver.max_solver_time_in_seconds, options.max_solver_time_s);
  ::ceres::StringToLinearSolverType(settings.Choice("linear_solver"), &solver.linear_solver_type);
  ::ceres::StringToSparseLinearAlgebraLibraryType(settings.Choice("sparse_library"),
                                                  &solver.sparse_linear_algebra_library_type);
  ::ceres::StringToTrustRegionStrategyType(settings.Choice("trust_region"),
                                           &solver.trust_region_strategy_type);
  solver.initial_trust_region_radius = settings.Number("initial_radius");
  solver.max_trust_region_radius =
      std::max(solver.max_trust_region_radius, solver.initial_trust_region_radius);
  solver.use_nonmonotonic_steps = settings.Boolean("nonmonotonic");
  solver.jacobi_scaling = settings.Boolean("jacobi_scaling");
  solver.gradient_tolerance = settings.Number("gradient_tolerance");
  solver.parameter_tolerance = settings.Number("parameter_tolerance");
  solver.num_threads = settings.Integer("threads");
  std::string error;
  if (!solver.IsValid(&error)) throw std::runtime_error(error);
  return solver;
}

}  // namespace

void CeresOptimizer::CheckOptions(const Options& options) const { SolverOptions(options); }

Summary CeresOptimizer::Optimize(const Options& options, std::span<const backend::Edge> edges,
                                 std::span<backend::Node> nodes) {
  backend::KeepsStart(options);  // as Ceres always does
  const PoseGraphView graph{nodes, edges};
  const ::ceres::Solver::Options solver_options = SolverOptions(options);
  const backend::GraphIndex index = backend::IndexGraph(graph);
  Summary summary;
  summary.initial_cost = summary.final_cost = backend::GraphCost(graph, index, options.loss);
  if (!std::isfinite(summary.initial_cost)) {
    summary.message = "the cost of the given poses is not finite";
    return summary;
  }
  PoseProblem problem(graph, index, options.loss);
  ::ceres::Solver::Summary ceres_summary;
  ::ceres::Solve(solver_options, problem.problem(), &ceres_summary);

  summary.message = ceres_summary.message;
  switch (ceres_summary.termination_type) {
    case ::ceres::CONVERGENCE:
      summary.termination = Termination::kConverged;
      break;
    case ::ceres::NO_CONVERGENCE:
      summary.termination = Termination::kNoConvergence;
      break;
    default:
      return summary;
  }
  for (std::size_t k = 1; k < ceres_summary.iterations.size(); ++k) {  // 0 is the start
    const ::ceres::IterationSummary& iteration = ceres_summary.iterations[k];
    summary.iterations.push_back(
        {iteration.cost, iteration.step_norm, 1.0 / iteration.trust_region_radius,
         iteration.step_solver_time_in_seconds, iteration.iteration_time_in_seconds});
  }
  std::vector<SE2> poses = problem.poses();
  for (SE2& pose : poses) pose.theta = backend::WrapAngle(pose.theta);
  const double final_cost = backend::GraphCost(graph, index, poses, options.loss);
  if (final_cost < summary.initial_cost) {
    summary.final_cost = final_cost;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (!index.fixed[k]) nodes[k].world_T_node = poses[k];
    }
  }
  return summary;
}

std::vector<Eigen::Matrix3d> CeresOptimizer::Covariances(
    std::span<const backend::Edge> edges, std::span<const backend::Node> nodes,
    std::span<const backend::EdgeNodes> pairs) {
  const PoseGraphView graph{nodes, edges};
  const backend::GraphIndex index = backend::IndexGraph(graph);
  PoseProblem problem(graph, index, {});
  // Each block once: Ceres dies of duplicates.
  std::vector<std::pair<const double*, const double*>> blocks;
  for (const auto& [i, j] : pairs) {
    blocks.emplace_back(problem.block(std::min(i, j)), problem.block(std::max(i, j)));
  }
  std::ranges::sort(blocks);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  ::ceres::Covariance covariance({});
  if (!covariance.Compute(blocks, problem.problem())) throw backend::NoCovariances();
  std::vector<Eigen::Matrix3d> result;
  result.reserve(pairs.size());
  for (const auto& [i, j] : pairs) {
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> block;
    covariance.GetCovarianceBlock(problem.block(i), problem.block(j), block.data());
    result.emplace_back(block);
  }
  return result;
}

}  // namespace gmapping_spa::ceres_backend
