// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/graduated_non_convexity.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <utility>

#include "backend/cost/edge_error.h"
#include "backend/cost/graph_cost.h"
#include "backend/graph/graph_index.h"
#include "backend/scheduling/optimize_safely.h"

namespace gmapping_spa::backend {
namespace {

constexpr double kControlFactor = 1.4;  // as in the paper
// From here on the surrogate differs from the loss by less than a thousandth of it.
constexpr double kLastControl = 1e3;

// The largest squared error of a loop closure.
double LargestSquaredError(const PoseGraph& graph, const GraphIndex& index) {
  double largest = 0.0;
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    if (edge.kind != EdgeKind::kLoopClosure) continue;
    const Eigen::Vector3d error = EdgeError(graph.nodes[index.edges[k].i].world_T_node,
                                            graph.nodes[index.edges[k].j].world_T_node, edge.i_T_j);
    largest = std::max(largest, error.dot(edge.information * error));
  }
  return largest;
}

// Appends a stage of the series to the summary of all.
void Append(Summary stage, Summary* all) {
  all->termination = stage.termination;
  all->message = std::move(stage.message);
  all->iterations.insert(all->iterations.end(), stage.iterations.begin(), stage.iterations.end());
}

}  // namespace

Summary OptimizeGradually(const Options& options, Optimizer* optimizer, PoseGraph* graph) {
  if (options.loss.kind != LossKind::kTruncated) {
    throw std::invalid_argument("graduated non-convexity needs the truncated loss");
  }
  const GraphIndex index = IndexGraph(*graph);
  const double initial_cost = GraphCost(*graph, index, options.loss);
  const std::vector<Node> before = graph->nodes;
  const auto deadline = DeadlineOf(options);
  // One stage, with the time that is left.
  const auto optimize = [&](Options stage) {
    if (deadline != std::chrono::steady_clock::time_point::max()) {
      const std::chrono::duration<double> left = deadline - std::chrono::steady_clock::now();
      stage.max_solver_time_s = std::max(0.0, left.count());
    }
    return OptimizeSafely(stage, optimizer, graph);
  };

  // Plain least squares is the limit of the surrogates that are convex.
  Summary summary;
  Options stage = options;
  stage.loss = {};
  Append(optimize(stage), &summary);
  stage.loss = options.loss;
  stage.initialization = Initialization::kKeep;
  const double k2 = options.loss.scale * options.loss.scale;
  // The paper's start: the largest error is just where the surrogate bends.
  double control = k2 / std::max(2.0 * LargestSquaredError(*graph, index) - k2, k2);
  while (control < kLastControl && summary.termination != Termination::kFailure) {
    stage.loss.control = control;
    Append(optimize(stage), &summary);
    control *= kControlFactor;
  }
  stage.loss = options.loss;
  if (summary.termination != Termination::kFailure) {
    Append(optimize(stage), &summary);
  }

  summary.initial_cost = initial_cost;
  summary.final_cost = GraphCost(*graph, index, options.loss);
  if (summary.termination == Termination::kFailure || summary.final_cost > initial_cost) {
    graph->nodes = before;
    summary.final_cost = initial_cost;
  }
  return summary;
}

}  // namespace gmapping_spa::backend
