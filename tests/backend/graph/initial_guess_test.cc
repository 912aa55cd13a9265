// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/initial_guess.h"

#include <gtest/gtest.h>

namespace gmapping_spa::backend::initial_guess_test {
namespace {

// A chain 0 - 1 - 2 - 3 of unit steps and a loop closure 0 -> 3 that says something else; node 9 is
// tied on by a loop closure only, and its edge points back.
PoseGraph ChainWithLoop() {
  PoseGraph graph;
  for (const std::int64_t id : {0, 1, 2, 3, 9}) graph.nodes.push_back({id, 0.0, {7, 7, 7}});
  graph.nodes[0].world_T_node = {1, 1, 0};
  for (std::int64_t k = 0; k < 3; ++k) graph.edges.push_back({k, k + 1, {1, 0, 0}});
  graph.edges.push_back({0, 3, {0, 5, 0}, Eigen::Matrix3d::Identity(), EdgeKind::kLoopClosure});
  graph.edges.push_back({9, 2, {1, 2, 0}, Eigen::Matrix3d::Identity(), EdgeKind::kLoopClosure});
  return graph;
}

TEST(InitializeFromOdometry, CrossesLoopClosuresOnlyWhereNothingElseLeadsOn) {
  const PoseGraph graph = ChainWithLoop();
  std::vector<SE2> poses = PosesOf(graph);
  InitializeFromOdometry(graph, IndexGraph(graph), &poses);
  EXPECT_EQ(poses[0], (SE2{1, 1, 0}));
  EXPECT_EQ(poses[3], (SE2{4, 1, 0}));
  EXPECT_EQ(poses[4], (SE2{2, -1, 0}));
}

TEST(InitializeFromSpanningTree, TakesTheFewestEdges) {
  const PoseGraph graph = ChainWithLoop();
  std::vector<SE2> poses = PosesOf(graph);
  InitializeFromSpanningTree(graph, IndexGraph(graph), &poses);
  EXPECT_EQ(poses[3], (SE2{1, 6, 0}));
}

TEST(InitializeFromOdometry, LeavesComponentsWhereTheirHeldNodesAre) {
  PoseGraph graph = ChainWithLoop();
  graph.edges.pop_back();  // node 9 is alone now
  graph.nodes[2].fixed = true;
  graph.nodes[2].world_T_node = {0, 0, 0};
  std::vector<SE2> poses = PosesOf(graph);
  InitializeFromOdometry(graph, IndexGraph(graph), &poses);
  EXPECT_EQ(poses[0], (SE2{-2, 0, 0}));
  EXPECT_EQ(poses[4], (SE2{7, 7, 7}));
}

}  // namespace
}  // namespace gmapping_spa::backend::initial_guess_test
