// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/covariances.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "backend/cost/closure_mixture.h"
#include "backend/cost/edge_error.h"
#include "backend/sparse/graph_covariance.h"

namespace gmapping_spa::backend {
namespace {

std::vector<Eigen::Matrix3d> CovariancesByFactor(const PoseGraphView& graph,
                                                 std::span<const EdgeNodes> pairs) {
  spa::GraphStructure structure;
  structure.Update(IndexGraph(graph));
  spa::NormalEquations equations;
  spa::BlockCholesky cholesky;
  auto covariances = spa::CovariancesOf(graph, pairs, structure, &equations, &cholesky);
  if (!covariances) throw NoCovariances();
  return *std::move(covariances);
}

// What shows that a result breaks the contract, or nothing.
std::string Violation(const GraphIndex& index, std::span<const EdgeNodes> pairs,
                      const std::vector<Eigen::Matrix3d>& covariances) {
  if (covariances.size() != pairs.size()) return "of another number of pairs";
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    if (!covariances[k].allFinite()) return "that is not finite";
    if ((index.fixed[i] || index.fixed[j]) && !covariances[k].isZero(0.0)) {
      return "of a held node that is not zero";
    }
    if (i == j && covariances[k].diagonal().minCoeff() < 0.0) return "with a negative variance";
  }
  return "";
}

}  // namespace

std::vector<Edge> EdgesOfResult(const Loss& loss, std::span<const Edge> edges,
                                const Summary& summary) {
  if (loss.kind == LossKind::kMixture) {
    return AcceptedEdges(edges, summary.edge_weights, summary.variance_factor);
  }
  std::vector<Edge> weighted;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (summary.edge_weights[k] == 0.0) continue;
    weighted.push_back(edges[k]);
    weighted.back().information *= summary.edge_weights[k];
  }
  return weighted;
}

std::vector<Eigen::Matrix3d> Covariances(const PoseGraphView& graph,
                                         std::span<const EdgeNodes> pairs, Optimizer* optimizer) {
  if (!optimizer->HasCovariances()) return CovariancesByFactor(graph, pairs);
  const GraphIndex index = IndexGraph(graph);
  std::vector<Eigen::Matrix3d> covariances;
  try {
    covariances = optimizer->Covariances(graph.edges, graph.nodes, pairs);
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string("the back end: ") + error.what());
  } catch (...) {
    throw std::runtime_error("the back end threw an exception of unknown type");
  }
  if (const std::string violation = Violation(index, pairs, covariances); !violation.empty()) {
    throw std::runtime_error("the back end returned a covariance " + violation);
  }
  return covariances;
}

Eigen::Matrix3d RelativeCovariance(const SE2& world_T_i, const SE2& world_T_j,
                                   const Eigen::Matrix3d& covariance_i,
                                   const Eigen::Matrix3d& covariance_ij,
                                   const Eigen::Matrix3d& covariance_j) {
  const LinearizedEdge edge = LinearizeEdge(world_T_i, world_T_j, {});
  const Eigen::Matrix3d &a = edge.jacobian_i, &b = edge.jacobian_j;
  const Eigen::Matrix3d half =
      0.5 * (a * covariance_i * a.transpose() + b * covariance_j * b.transpose()) +
      a * covariance_ij * b.transpose();
  return half + half.transpose();
}

}  // namespace gmapping_spa::backend
