// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/optimize_safely.h"

#include <cmath>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "backend/cost/graph_cost.h"
#include "backend/graph/graph_index.h"

namespace gmapping_spa::backend {
namespace {

// Two ways to sum the same cost differ by rounding; that is no higher cost.
constexpr double kRoundingTolerance = 1e-12;

// What the result breaks of the contract, or nothing. Leaves its cost in `*cost`.
std::string Violation(const PoseGraph& result, const std::vector<Node>& before,
                      const GraphIndex& index, const Options& options, double initial_cost,
                      double* cost) {
  for (std::size_t k = 0; k < before.size(); ++k) {
    const Node &node = result.nodes[k], &original = before[k];
    if (node.id != original.id || node.fixed != original.fixed ||
        node.stamp_s != original.stamp_s) {
      return "it changed more of node " + std::to_string(original.id) + " than the pose";
    }
    if (!node.world_T_node.IsFinite()) {
      return "it returned a pose of node " + std::to_string(node.id) + " that is not finite";
    }
    if (index.fixed[k] && !(node.world_T_node == original.world_T_node)) {
      return "it moved node " + std::to_string(node.id) + ", which is fixed";
    }
  }
  *cost = GraphCost(result, index, options.loss);
  if (!(*cost <= initial_cost * (1.0 + kRoundingTolerance))) {
    return "it returned poses that cost " + std::to_string(*cost) + " instead of " +
           std::to_string(initial_cost);
  }
  return "";
}

// Puts the poses of the initialization into the graph, if they can be had. Returns what the user
// should know, or nothing.
std::string Initialize(Initialization initialization, const GraphIndex& index, const Loss& loss,
                       PoseGraph* graph) {
  const std::optional<std::vector<SE2>> poses = InitialPoses(initialization, *graph, index);
  if (!poses || !std::isfinite(GraphCost(*graph, index, *poses, loss))) {
    return std::string("the edges do not determine the initialization ") +
           InitializationName(initialization) + ": it started from the given poses; ";
  }
  for (std::size_t k = 0; k < poses->size(); ++k) graph->nodes[k].world_T_node = (*poses)[k];
  return "";
}

// Optimizes from where the options say; `before` has the given poses, which cost initial_cost.
// Throws what the optimizer throws.
Summary OptimizeFromStart(const Options& options, const GraphIndex& index,
                          const std::vector<Node>& before, double initial_cost,
                          Optimizer* optimizer, PoseGraph* graph) {
  Options told = options;
  std::string remark;
  double start_cost = initial_cost;
  if (options.initialization != Initialization::kAuto &&
      options.initialization != Initialization::kKeep) {
    remark = Initialize(options.initialization, index, options.loss, graph);
    told.initialization = Initialization::kKeep;
    start_cost = GraphCost(*graph, index, options.loss);
  }
  Summary summary = optimizer->Optimize(told, graph->edges, graph->nodes);
  if (summary.termination == Termination::kFailure) return summary;
  const std::string violation =
      Violation(*graph, before, index, options, start_cost, &summary.final_cost);
  if (!violation.empty()) {
    summary.termination = Termination::kFailure;
    summary.message = violation;
  } else if (summary.final_cost > initial_cost * (1.0 + kRoundingTolerance)) {
    summary.message += "; the given poses cost less and are kept";
    summary.final_cost = initial_cost;
    graph->nodes = before;
  }
  summary.message.insert(0, remark);
  return summary;
}

}  // namespace

Summary OptimizeSafely(const Options& options, Optimizer* optimizer, PoseGraph* graph) {
  const GraphIndex index = IndexGraph(*graph);
  const double initial_cost = GraphCost(*graph, index, options.loss);
  const std::vector<Node> before = graph->nodes;

  Summary summary;
  try {
    optimizer->CheckOptions(options);
    summary = OptimizeFromStart(options, index, before, initial_cost, optimizer, graph);
  } catch (const std::bad_alloc&) {
    summary.message = "out of memory for " + std::to_string(graph->nodes.size()) + " nodes and " +
                      std::to_string(graph->edges.size()) + " edges";
  } catch (const std::exception& error) {
    summary.message = std::string("it threw: ") + error.what();
  } catch (...) {
    summary.message = "it threw an exception of unknown type";
  }
  if (summary.termination == Termination::kFailure) {
    graph->nodes = before;
    summary.final_cost = initial_cost;
  }
  summary.initial_cost = initial_cost;
  return summary;
}

}  // namespace gmapping_spa::backend
