// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/graph_covariance.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <random>

#include "backend/cost/edge_error.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::spa {
namespace {

using backend::EdgeNodes;
using backend::PoseGraph;

std::optional<std::vector<Eigen::Matrix3d>> Covariances(const PoseGraph& graph,
                                                        std::span<const EdgeNodes> pairs) {
  GraphStructure structure;
  structure.Update(backend::IndexGraph(graph));
  NormalEquations equations;
  BlockCholesky cholesky;
  return CovariancesOf(graph, pairs, structure, &equations, &cholesky);
}

// Of all nodes: the inverse of the Hessian of the free ones, zero elsewhere.
Eigen::MatrixXd DenseCovariance(const PoseGraph& graph) {
  const backend::GraphIndex index = backend::IndexGraph(graph);
  const auto size = static_cast<Eigen::Index>(3 * graph.nodes.size());
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const auto [i, j] = index.edges[k];
    const backend::LinearizedEdge edge = backend::LinearizeEdge(
        graph.nodes[i].world_T_node, graph.nodes[j].world_T_node, graph.edges[k].i_T_j);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, size);
    jacobian.middleCols<3>(3 * i) += edge.jacobian_i;
    jacobian.middleCols<3>(3 * j) += edge.jacobian_j;
    hessian += jacobian.transpose() * graph.edges[k].information * jacobian;
  }
  std::vector<int> free;
  for (int k = 0; k < size; ++k) {
    if (!index.fixed[k / 3]) free.push_back(k);
  }
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(size, size);
  const Eigen::MatrixXd inverse = hessian(free, free).eval().inverse();
  covariance(free, free) = inverse;
  return covariance;
}

// Two components with fixed nodes in them, ids in no order, anisotropic information.
PoseGraph GraphInPieces(unsigned seed) {
  PoseGraph graph = backend::RandomGraph(seed, {.nodes = 25, .loop_closures = 6});
  PoseGraph other = backend::RandomGraph(seed + 100, {.nodes = 15, .loop_closures = 3});
  for (backend::Node& node : other.nodes) node.id += 1000;
  for (backend::Edge& edge : other.edges) edge.i += 1000, edge.j += 1000;
  graph.nodes.insert(graph.nodes.end(), other.nodes.begin(), other.nodes.end());
  graph.edges.insert(graph.edges.end(), other.edges.begin(), other.edges.end());
  graph.nodes[7].fixed = graph.nodes[20].fixed = true;
  std::shuffle(graph.nodes.begin(), graph.nodes.end(), std::mt19937(seed));
  return graph;
}

TEST(CovariancesOf, AreThoseOfTheDenseInverseForAnyPairs) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const PoseGraph graph = GraphInPieces(seed);
    const Eigen::MatrixXd dense = DenseCovariance(graph);
    const int nodes = static_cast<int>(graph.nodes.size());
    std::vector<EdgeNodes> all, few;
    for (int i = 0; i < nodes; ++i) {
      for (int j = 0; j < nodes; ++j) all.push_back({i, j});
    }
    std::ranges::sample(all, std::back_inserter(few), 4, std::mt19937(seed));
    for (const std::vector<EdgeNodes>& pairs : {all, few}) {
      const auto covariances = Covariances(graph, pairs);
      ASSERT_TRUE(covariances);
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        EXPECT_LT(((*covariances)[k] - dense.block<3, 3>(3 * pairs[k].i, 3 * pairs[k].j)).norm(),
                  1e-10 * dense.norm());
      }
    }
  }
}

TEST(CovariancesOf, AreZeroForHeldNodesAndBetweenComponents) {
  const PoseGraph graph = GraphInPieces(3);
  const backend::GraphIndex index = backend::IndexGraph(graph);
  const std::vector<int> component = backend::ComponentsOf(index);
  std::vector<EdgeNodes> pairs;
  for (int i = 0; i < static_cast<int>(graph.nodes.size()); ++i) {
    for (int j = 0; j < static_cast<int>(graph.nodes.size()); ++j) {
      if (index.fixed[i] || component[i] != component[j]) pairs.push_back({i, j});
    }
  }
  ASSERT_GT(pairs.size(), 2u * 25u * 15u);
  const auto covariances = Covariances(graph, pairs);
  ASSERT_TRUE(covariances);
  for (const Eigen::Matrix3d& covariance : *covariances) {
    EXPECT_EQ(covariance, Eigen::Matrix3d::Zero());
  }
}

TEST(CovariancesOf, DoNotExistWhereEdgesDoNotDetermineThePoses) {
  PoseGraph graph = backend::RandomGraph(1);
  const std::vector<EdgeNodes> pairs = {{3, 3}};
  EXPECT_TRUE(Covariances(graph, pairs));
  graph.nodes.push_back({77, 0.0, {1, 2, 3}});
  EXPECT_TRUE(Covariances(graph, pairs));  // a component that is held
  graph.edges.push_back({5, 77, {1, 0, 0}, Eigen::Matrix3d::Zero()});
  EXPECT_FALSE(Covariances(graph, pairs));
  graph.edges.back().information.diagonal() << 1.0, 1.0, 0.0;  // no heading
  EXPECT_FALSE(Covariances(graph, pairs));
}

TEST(CovariancesOf, OfAGraphWithNothingFreeAreZero) {
  PoseGraph graph = backend::RandomGraph(1, {.nodes = 1, .loop_closures = 0});
  const std::vector<EdgeNodes> pairs = {{0, 0}};
  const auto covariances = Covariances(graph, pairs);
  ASSERT_TRUE(covariances);
  EXPECT_EQ(covariances->front(), Eigen::Matrix3d::Zero());
  EXPECT_TRUE(Covariances({}, {})->empty());
}

}  // namespace
}  // namespace gmapping_spa::spa
