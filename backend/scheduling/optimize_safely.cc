#include "backend/scheduling/optimize_safely.h"

#include <cmath>
#include <exception>
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

}  // namespace

Summary OptimizeSafely(const Options& options, Optimizer* optimizer, PoseGraph* graph) {
  const GraphIndex index = IndexGraph(*graph);
  const double initial_cost = GraphCost(*graph, index, options.loss);
  const std::vector<Node> before = graph->nodes;

  Summary summary;
  double final_cost = initial_cost;
  try {
    summary = optimizer->Optimize(options, graph->edges, graph->nodes);
    const std::string violation =
        summary.termination == Termination::kFailure
            ? summary.message
            : Violation(*graph, before, index, options, initial_cost, &final_cost);
    if (!violation.empty()) {
      summary.termination = Termination::kFailure;
      summary.message = violation;
    }
  } catch (const std::exception& error) {
    summary.termination = Termination::kFailure;
    summary.message = std::string("it threw: ") + error.what();
  } catch (...) {
    summary.termination = Termination::kFailure;
    summary.message = "it threw an exception of unknown type";
  }
  if (summary.termination == Termination::kFailure) {
    graph->nodes = before;
    final_cost = initial_cost;
  }
  summary.initial_cost = initial_cost;
  summary.final_cost = final_cost;
  return summary;
}

}  // namespace gmapping_spa::backend
