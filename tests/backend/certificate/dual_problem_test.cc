// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/dual_problem.h"

#include <gtest/gtest.h>

#include "backend/cost/edge_error.h"
#include "backend/cost/graph_cost.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend::dual_problem_test {
namespace {

// A random graph with a second fixed node, with its dual problem at the given poses.
class DualProblemTest : public ::testing::Test {
 protected:
  DualProblemTest() {
    graph_.nodes[7].fixed = graph_.nodes[0].fixed = true;
    structure_.Update(IndexGraph(graph_));
    std::vector<InformationSplit> splits;
    std::vector<Eigen::Vector3d> tangents;
    for (std::size_t k = 0; k < graph_.edges.size(); ++k) {
      const auto [i, j] = structure_.index().edges[k];
      splits.push_back(SplitInformation(graph_.edges[k].information));
      tangents.push_back(EdgeError(graph_.nodes[i].world_T_node, graph_.nodes[j].world_T_node,
                                   graph_.edges[k].i_T_j));
      if (k % 4 == 0) tangents.back() += Eigen::Vector3d(0.1, -0.2, 0.05);
    }
    dual_ = MakeDualProblem(graph_, structure_, splits, PosesOf(graph_), tangents);
  }

  LiftedVector Change(const std::vector<SE2>& poses) const {
    LiftedVector change;
    for (const int node : structure_.blocks().node_of_column) {
      const SE2 &to = poses[node], &from = graph_.nodes[node].world_T_node;
      change.emplace_back(to.x - from.x, to.y - from.y, std::cos(to.theta) - std::cos(from.theta),
                          std::sin(to.theta) - std::sin(from.theta));
    }
    return change;
  }

  // The lower bound at other poses.
  double Bound(const std::vector<SE2>& poses) const {
    const LiftedVector w = Change(poses);
    return GraphCost(graph_) - dual_.slack + Dot(dual_.gradient, w) +
           0.5 * Dot(w, Multiply(structure_.blocks(), dual_.matrix, w));
  }

  PoseGraph graph_ = RandomGraph(4, {.nodes = 15, .loop_closures = 10});
  spa::GraphStructure structure_;
  DualProblem dual_;
};

TEST_F(DualProblemTest, IsNowhereAboveTheCost) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 300; ++trial) {
    const double sigma = std::pow(10.0, -trial % 5);
    std::vector<SE2> poses = PosesOf(graph_);
    for (const int node : structure_.blocks().node_of_column) {
      poses[node] = Plus(poses[node],
                         sigma * Eigen::Vector3d(normal(random), normal(random), normal(random)));
    }
    const double cost = GraphCost(graph_, structure_.index(), poses);
    EXPECT_LE(Bound(poses), cost * (1.0 + 1e-9)) << sigma;
  }
  EXPECT_GT(dual_.slack, 0.0);
  EXPECT_LT(dual_.slack, GraphCost(graph_));
}

TEST_F(DualProblemTest, TouchesTheCostWhereTheTangentsAreTheErrors) {
  std::vector<InformationSplit> splits;
  std::vector<Eigen::Vector3d> tangents;
  for (std::size_t k = 0; k < graph_.edges.size(); ++k) {
    const auto [i, j] = structure_.index().edges[k];
    splits.push_back(SplitInformation(graph_.edges[k].information));
    tangents.push_back(EdgeError(graph_.nodes[i].world_T_node, graph_.nodes[j].world_T_node,
                                 graph_.edges[k].i_T_j));
  }
  dual_ = MakeDualProblem(graph_, structure_, splits, PosesOf(graph_), tangents);
  EXPECT_EQ(dual_.slack, 0.0);
  const int node = structure_.blocks().node_of_column[3];
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1)}) {
    std::vector<SE2> there = PosesOf(graph_), back = there;
    there[node] = Plus(there[node], 1e-5 * axis);
    back[node] = Plus(back[node], -1e-5 * axis);
    const double derivative = (GraphCost(graph_, structure_.index(), there) -
                               GraphCost(graph_, structure_.index(), back)) /
                              2e-5;
    EXPECT_NEAR((Bound(there) - Bound(back)) / 2e-5, derivative,
                1e-5 * (1.0 + std::abs(derivative)));
  }
}

}  // namespace
}  // namespace gmapping_spa::backend::dual_problem_test
