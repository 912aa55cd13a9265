// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/staircase.h"

#include <gtest/gtest.h>

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <fstream>

#include "backend/cost/graph_cost.h"
#include "backend/graph/g2o_io.h"
#include "backend/spa/spa_optimizer.h"
#include "tests/backend/certificate/wound_ring.h"
#include "tests/backend/random_graph.h"
#include "tests/real_data.h"

namespace gmapping_spa::backend::staircase_test {
namespace {

TEST(Staircase, UnwindsARing) {
  for (const int nodes : {8, 20, 50}) {
    for (const int turns : {2, 3, -1}) {
      PoseGraph graph = WoundRing(nodes, turns);
      spa::SpaOptimizer optimizer;
      const StaircaseResult result = ClimbStaircase({}, &optimizer, &graph);
      EXPECT_TRUE(result.certificate.optimal()) << nodes << " " << turns;
      EXPECT_LT(GraphCost(graph), 1e-9);
      EXPECT_EQ(result.certificate.cost, GraphCost(graph));
      EXPECT_GT(result.initial_cost, 1.0);
      ASSERT_FALSE(result.descents.empty());
      EXPECT_TRUE(result.descents.back().accepted);
      EXPECT_GE(result.descents.back().rank, 4);
    }
  }
}

TEST(Staircase, LeavesPosesAsTheyAreWhenAsked) {
  PoseGraph graph = WoundRing(20, 2);
  const std::vector<SE2> poses = PosesOf(graph);
  spa::SpaOptimizer optimizer;
  const StaircaseResult result = ClimbStaircase({.descend = false}, &optimizer, &graph);
  EXPECT_FALSE(result.certificate.optimal());
  EXPECT_LT(result.certificate.smallest_eigenvalue, 0.0);
  EXPECT_TRUE(result.descents.empty());
  EXPECT_EQ(PosesOf(graph), poses);
}

TEST(Staircase, NeverEndsWorseThanItBegan) {
  int optimal = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    PoseGraph graph =
        RandomGraph(seed, {.nodes = 12, .loop_closures = 12, .measurement_noise = 0.5});
    const double before = GraphCost(graph);
    spa::SpaOptimizer optimizer;
    const StaircaseResult result = ClimbStaircase({}, &optimizer, &graph);
    EXPECT_LE(GraphCost(graph), before);
    EXPECT_EQ(result.certificate.cost, GraphCost(graph));
    EXPECT_EQ(result.initial_cost, before);
    EXPECT_LE(result.certificate.lower_bound, result.certificate.cost);
    optimal += result.certificate.optimal() ? 1 : 0;
  }
  EXPECT_GE(optimal, 5);
}

// An optimizer that fails.
class Failing : public Optimizer {
 public:
  Summary Optimize(const Options& /*options*/, std::span<const Edge> /*edges*/,
                   std::span<Node> nodes) override {
    for (Node& node : nodes) node.world_T_node.x = std::nan("");
    return {};
  }
};

TEST(Staircase, KeepsThePosesWhereTheOptimizerFails) {
  PoseGraph graph = WoundRing(20, 2);
  const std::vector<SE2> poses = PosesOf(graph);
  Failing optimizer;
  const StaircaseResult result = ClimbStaircase({}, &optimizer, &graph);
  EXPECT_FALSE(result.certificate.optimal());
  EXPECT_EQ(PosesOf(graph), poses);
  for (const Descent& descent : result.descents) EXPECT_FALSE(descent.accepted);
}

// Public graphs with their best known cost, started where optimizers get stuck: at the file's
// poses.
class StaircaseOnPublicGraphs : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(StaircaseOnPublicGraphs, LeavesLocalMinimaForTheCertifiedOptimum) {
  const auto path = RealDataPath("g2o/" + std::string(GetParam().first) + ".g2o.gz");
  if (!path) GTEST_SKIP() << "no real data";
  std::ifstream file(*path, std::ios::binary);
  boost::iostreams::filtering_istream in;
  in.push(boost::iostreams::gzip_decompressor());
  in.push(file);
  PoseGraph graph = ReadG2o(in, *path);
  spa::SpaOptimizer optimizer;
  Options keep;
  keep.initialization = Initialization::kKeep;
  optimizer.Optimize(keep, graph.edges, graph.nodes);
  EXPECT_GT(GraphCost(graph), 1.5 * GetParam().second);
  const StaircaseResult result = ClimbStaircase({}, &optimizer, &graph);
  EXPECT_TRUE(result.certificate.optimal());
  EXPECT_NEAR(GraphCost(graph), GetParam().second, 1e-6 * GetParam().second);
}

INSTANTIATE_TEST_SUITE_P(, StaircaseOnPublicGraphs,
                         testing::Values(std::pair("MIT", 19.800647242),
                                         std::pair("M3500c", 1277.366195)),
                         [](const auto& test) { return std::string(test.param.first); });

}  // namespace
}  // namespace gmapping_spa::backend::staircase_test
