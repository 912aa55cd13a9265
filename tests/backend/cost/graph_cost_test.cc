// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/graph_cost.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gmapping_spa::backend {
namespace {

// Two edges of squared error 4 each: an odometry edge off by 2 m, a loop closure off by 1 rad.
PoseGraph TwoErrors() {
  PoseGraph graph;
  graph.nodes = {{0, 0, {0, 0, 0}}, {1, 0, {3, 0, 1}}};
  Eigen::Matrix3d information = Eigen::Vector3d(1, 1, 4).asDiagonal();
  graph.edges = {{0, 1, {1, 0, 1}, information, EdgeKind::kOdometry},
                 {0, 1, {3, 0, 0}, information, EdgeKind::kLoopClosure}};
  return graph;
}

TEST(GraphCost, IsHalfTheSumOfSquaredErrors) { EXPECT_DOUBLE_EQ(GraphCost(TwoErrors()), 4.0); }

TEST(GraphCost, AppliesTheLossToLoopClosuresAlone) {
  EXPECT_DOUBLE_EQ(GraphCost(TwoErrors(), Loss{LossKind::kTruncated, 1.0}), 2.0 + 0.5);
}

TEST(GraphCost, TakesOtherPosesThanThoseOfTheGraph) {
  const PoseGraph graph = TwoErrors();
  const std::vector<SE2> poses = {{0, 0, 0}, {1, 0, 1}};
  EXPECT_DOUBLE_EQ(GraphCost(graph, IndexGraph(graph), poses), 0.5 * (0 + 4 + 4));
}

TEST(GraphCost, RejectsEdgesToNowhere) {
  PoseGraph graph = TwoErrors();
  graph.edges[0].j = 7;
  EXPECT_THROW(GraphCost(graph), std::invalid_argument);
}

}  // namespace
}  // namespace gmapping_spa::backend
