// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/optimize.h"

#include <algorithm>
#include <string>

#include "backend/cost/edge_error.h"
#include "backend/cost/graph_cost.h"
#include "backend/graph/graph_index.h"
#include "backend/scheduling/graduated_non_convexity.h"
#include "backend/scheduling/optimize_safely.h"
#include "backend/scheduling/robust_optimization.h"

namespace gmapping_spa::backend {
namespace {

std::vector<double> LossWeights(const PoseGraph& graph, const Loss& loss) {
  std::vector<double> weights = SquaredErrors(graph, IndexGraph(graph), PosesOf(graph));
  for (std::size_t k = 0; k < weights.size(); ++k) {
    weights[k] = EvaluateLoss(LossOfEdge(graph.edges[k], loss), weights[k]).weight;
  }
  return weights;
}

}  // namespace

Summary Optimize(const Options& options, bool graduated, Optimizer* optimizer, PoseGraph* graph) {
  Summary summary;
  switch (options.loss.kind) {
    case LossKind::kMixture:
      summary = OptimizeRobustly(options, optimizer, graph);
      break;
    case LossKind::kTruncated:
      summary = graduated ? OptimizeGradually(options, optimizer, graph)
                          : OptimizeSafely(options, optimizer, graph);
      break;
    default:
      summary = OptimizeSafely(options, optimizer, graph);
  }
  if (summary.termination == Termination::kFailure) return summary;
  if (options.loss.kind != LossKind::kMixture) {
    summary.edge_weights = LossWeights(*graph, options.loss);
  }
  const std::size_t rejected = RejectedClosures(graph->edges, summary).size();
  if (rejected > 0) {
    const auto closures = static_cast<std::size_t>(std::ranges::count(
        graph->edges, EdgeKind::kLoopClosure, [](const Edge& edge) { return edge.kind; }));
    summary.message += "; " + std::to_string(rejected) + " of " + std::to_string(closures) +
                       " loop closures are rejected";
    if (2 * rejected > closures) {
      summary.message += ": that is most of them, and the poses may be little better than odometry";
    }
  }
  return summary;
}

void CheckOptions(const Options& options, const Optimizer& optimizer) {
  Options told = options;
  if (told.loss.kind == LossKind::kMixture) told.loss.kind = LossKind::kDcs;
  optimizer.CheckOptions(told);
}

std::vector<std::size_t> RejectedClosures(std::span<const Edge> edges, const Summary& summary) {
  std::vector<std::size_t> rejected;
  for (std::size_t k = 0; k < summary.edge_weights.size(); ++k) {
    if (edges[k].kind == EdgeKind::kLoopClosure && summary.edge_weights[k] < 0.5) {
      rejected.push_back(k);
    }
  }
  return rejected;
}

}  // namespace gmapping_spa::backend
