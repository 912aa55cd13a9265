// SPDX-License-Identifier: BSD-3-Clause
#include "backend/initialization/chordal_initialization.h"

#include <gtest/gtest.h>

#include "backend/cost/graph_cost.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::spa {
namespace {

using backend::PoseGraph;
using backend::SE2;

std::vector<SE2> Chordal(const PoseGraph& graph) {
  GraphStructure structure;
  structure.Update(IndexGraph(graph));
  SolverMemory memory;
  std::vector<SE2> poses = PosesOf(graph);
  EXPECT_TRUE(InitializeChordal(graph, structure, &memory, &poses));
  return poses;
}

TEST(InitializeChordal, FindsThePosesThatPerfectMeasurementsAgreeOn) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    PoseGraph graph = backend::RandomGraph(seed, {.measurement_noise = 0.0, .pose_noise = 3.0});
    graph.nodes[0].world_T_node = {5, -3, 2};
    const std::vector<SE2> poses = Chordal(graph);
    EXPECT_EQ(poses[0], (SE2{5, -3, 2}));
    EXPECT_LT(GraphCost(graph, IndexGraph(graph), poses), 1e-16);
  }
}

TEST(InitializeChordalJointly, FindsThePosesThatPerfectMeasurementsAgreeOn) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    PoseGraph graph = backend::RandomGraph(seed, {.measurement_noise = 0.0, .pose_noise = 3.0});
    graph.nodes[0].world_T_node = {5, -3, 2};
    GraphStructure structure;
    structure.Update(IndexGraph(graph));
    SolverMemory memory;
    std::vector<SE2> poses = PosesOf(graph);
    ASSERT_TRUE(InitializeChordalJointly(graph, structure, &memory, &poses));
    EXPECT_EQ(poses[0], (SE2{5, -3, 2}));
    EXPECT_LT(GraphCost(graph, IndexGraph(graph), poses), 1e-16);
  }
}

TEST(InitializeChordal, StartsNearTheMinimumWhereverTheGivenPosesAre) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    PoseGraph graph = backend::RandomGraph(seed, {.pose_noise = 0.0});
    const double cost_of_truth = GraphCost(graph);
    for (std::size_t k = 1; k < graph.nodes.size(); ++k) {
      graph.nodes[k].world_T_node = {100.0 * k, 0, 1.0 * k};
    }
    EXPECT_LT(GraphCost(graph, IndexGraph(graph), Chordal(graph)), 3.0 * cost_of_truth);
  }
}

TEST(InitializeChordal, LeavesFixedNodesWhereTheyAre) {
  PoseGraph graph = backend::RandomGraph(2);
  for (const int k : {3, 11}) graph.nodes[k].fixed = true;
  const std::vector<SE2> poses = Chordal(graph);
  for (const int k : {3, 11}) EXPECT_EQ(poses[k], graph.nodes[k].world_T_node);
}

TEST(InitializeChordal, RefusesGraphsThatDoNotDetermineThePoses) {
  PoseGraph graph = backend::RandomGraph(2, {.loop_closures = 0});
  graph.edges.back().information.setZero();  // in the middle, rounding may hide it
  GraphStructure structure;
  structure.Update(IndexGraph(graph));
  SolverMemory memory;
  std::vector<SE2> poses = PosesOf(graph);
  EXPECT_FALSE(InitializeChordal(graph, structure, &memory, &poses));
}

}  // namespace
}  // namespace gmapping_spa::spa
