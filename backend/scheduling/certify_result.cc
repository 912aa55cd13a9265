// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/certify_result.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "backend/cost/closure_mixture.h"
#include "backend/cost/graph_cost.h"
#include "backend/graph/graph_index.h"
#include "backend/scheduling/covariances.h"

namespace gmapping_spa::backend {
namespace {

std::string Number(double value, const char* format = "%.3g") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// The graph with the edges, and their information, that are certified.
PoseGraph CertifiedGraph(const Loss& loss, const PoseGraph& graph, const Summary& summary) {
  return {.nodes = graph.nodes, .edges = EdgesOfResult(loss, graph.edges, summary)};
}

std::string ProblemOf(const Loss& loss, const PoseGraph& certified, const PoseGraph& graph,
                      double variance_factor) {
  const std::string count = std::to_string(certified.edges.size());
  if (loss.kind != LossKind::kMixture && loss.kind != LossKind::kNone) {
    return "least squares of " + count + " edges with the weights of the loss " +
           LossKindName(loss.kind) + " at the poses, not the loss itself";
  }
  std::string problem = "least squares of ";
  problem += certified.edges.size() == graph.edges.size()
                 ? "all " + count + " edges"
                 : "the " + count + " of " + std::to_string(graph.edges.size()) +
                       " edges that are not rejected";
  if (variance_factor != 1.0) {
    problem += ", loop closures with " + Number(variance_factor) + " times their covariance";
  }
  return problem;
}

std::string MessageOf(const StaircaseResult& result) {
  const Certificate& certificate = result.certificate;
  const std::string gap = Number(certificate.relative_gap);
  std::string message;
  if (certificate.relative_gap <= kOptimalGap) {
    message = "the poses are the global optimum: no others cost less by more than " + gap +
              " of the cost";
  } else if (certificate.optimal()) {
    message = "the poses are the global optimum: no others cost less by more than " +
              Number(certificate.cost - certificate.lower_bound);
  } else if (certificate.positive_definite) {
    message = "the poses are near the global optimum, not at it: others may cost less by " + gap +
              " of the cost";
  } else if (certificate.lower_bound > 0.0) {
    message = "undecided: other poses may cost less, by at most " + gap + " of the cost";
  } else {
    message = "undecided: other poses may cost less, and no lower bound was found";
  }
  if (certificate.cost < result.initial_cost) {
    const double factor = result.initial_cost / certificate.cost;
    message += "; the back end's poses cost " +
               (factor < 2.0 ? Number(100.0 * (factor - 1.0)) + " % more"
                             : Number(factor, "%.4g") + " times as much") +
               " and are replaced";
  }
  return message;
}

void SetPoses(const std::vector<SE2>& poses, PoseGraph* graph) {
  for (std::size_t k = 0; k < poses.size(); ++k) graph->nodes[k].world_T_node = poses[k];
}

// Takes over better poses under the mixture of the old ones. False when they are not better, or
// would have other closures rejected than those that were certified.
bool TakeOver(const std::vector<SE2>& poses, PoseGraph* graph, Summary* summary) {
  const GraphIndex index = IndexGraph(*graph);
  const std::vector<SE2> old = PosesOf(*graph);
  const ClosureMixture mixture = FitClosureMixture(*graph, index, old);
  const double cost = MixtureCost(*graph, index, poses, mixture);
  if (cost > MixtureCost(*graph, index, old, mixture)) return false;
  ClosureMixture refitted = FitClosureMixture(*graph, index, poses);
  if (!std::ranges::equal(refitted.inlier_probability, summary->edge_weights,
                          [](double p, double q) { return (p < 0.5) == (q < 0.5); })) {
    return false;
  }
  SetPoses(poses, graph);
  summary->edge_weights = std::move(refitted.inlier_probability);
  summary->final_cost = cost;
  return true;
}

}  // namespace

CertifiedResult CertifyResult(const Loss& loss, bool descend, Optimizer* optimizer,
                              PoseGraph* graph, Summary* summary) {
  PoseGraph certified = CertifiedGraph(loss, *graph, *summary);
  const bool least_squares = loss.kind == LossKind::kNone || loss.kind == LossKind::kMixture;
  const bool all_edges = certified.edges.size() == graph->edges.size() &&
                         summary->variance_factor == 1.0 && least_squares;
  CertifiedResult result;
  result.problem = ProblemOf(loss, certified, *graph, summary->variance_factor);
  StaircaseOptions options;
  options.descend = descend && least_squares;
  result.staircase = ClimbStaircase(options, optimizer, &certified);
  result.message = MessageOf(result.staircase);
  const std::vector<SE2> poses = PosesOf(certified);
  if (poses == PosesOf(*graph)) return result;
  if (all_edges) {
    SetPoses(poses, graph);
    summary->final_cost = result.staircase.certificate.cost;
  } else if (!TakeOver(poses, graph, summary)) {
    options.descend = false;
    certified = CertifiedGraph(loss, *graph, *summary);
    std::vector<Descent> descents = std::move(result.staircase.descents);
    result.staircase = ClimbStaircase(options, optimizer, &certified);
    for (Descent& descent : descents) descent.accepted = false;
    result.staircase.descents = std::move(descents);
    result.message = MessageOf(result.staircase) +
                     "; poses that explain these edges better reject other ones, and are not taken";
  }
  return result;
}

}  // namespace gmapping_spa::backend
