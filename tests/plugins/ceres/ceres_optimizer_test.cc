// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/ceres/ceres_optimizer.h"

#include <gmock/gmock.h>

#include <utility>

#include "backend/cost/graph_cost.h"
#include "backend/spa/spa_optimizer.h"
#include "tests/backend/random_graph.h"
#include "tests/message_of.h"

namespace gmapping_spa::ceres_backend {
namespace {

using backend::Options;
using backend::PoseGraph;
using backend::Summary;
using backend::Termination;
using ::testing::HasSubstr;

Summary Optimize(PoseGraph* graph, const Options& options = {}) {
  return CeresOptimizer().Optimize(options, graph->edges, graph->nodes);
}

TEST(CeresOptimizer, EndsWhereSpaEndsWithEveryLinearSolver) {
  for (const char* solver :
       {"sparse_normal_cholesky", "dense_normal_cholesky", "dense_qr", "cgnr"}) {
    PoseGraph graph = backend::RandomGraph(3);
    PoseGraph by_spa = graph;
    Options options;
    options.cost_tolerance = 1e-12;
    const Summary expected = spa::SpaOptimizer().Optimize(options, by_spa.edges, by_spa.nodes);
    options.settings = {{"linear_solver", solver}};
    const Summary summary = Optimize(&graph, options);
    EXPECT_EQ(summary.termination, Termination::kConverged) << solver;
    EXPECT_NEAR(summary.final_cost, expected.final_cost, 1e-6 * expected.final_cost) << solver;
  }
}

TEST(CeresOptimizer, ReportsCostsThatGraphCostConfirms) {
  PoseGraph graph = backend::RandomGraph(1);
  const double initial_cost = GraphCost(graph);
  const Summary summary = Optimize(&graph);
  EXPECT_NEAR(summary.initial_cost, initial_cost, 1e-9 * initial_cost);
  EXPECT_NEAR(summary.final_cost, GraphCost(graph), 1e-9 * summary.final_cost);
  EXPECT_LT(summary.final_cost, initial_cost);
  EXPECT_FALSE(summary.iterations.empty());
}

TEST(CeresOptimizer, HoldsTheFirstNode) {
  PoseGraph graph = backend::RandomGraph(2);
  const backend::SE2 first = graph.nodes.front().world_T_node;
  Optimize(&graph);
  EXPECT_EQ(graph.nodes.front().world_T_node.x, first.x);
  EXPECT_EQ(graph.nodes.front().world_T_node.y, first.y);
  EXPECT_EQ(graph.nodes.front().world_T_node.theta, first.theta);
}

TEST(CeresOptimizer, OutOfIterationsIsNoConvergenceAndNotWorse) {
  PoseGraph graph = backend::RandomGraph(5);
  Options options;
  options.max_iterations = 1;
  const Summary summary = Optimize(&graph, options);
  EXPECT_EQ(summary.termination, Termination::kNoConvergence);
  EXPECT_LE(GraphCost(graph), summary.initial_cost);
}

TEST(CeresOptimizer, SettingsThatMakeNoSenseAreRefusedAndLeaveThePoses) {
  for (const auto& [name, value] : {std::pair("trust_region", "circle"), std::pair("threads", "0"),
                                    std::pair("trust_regoin", "dogleg")}) {
    PoseGraph graph = backend::RandomGraph(1);
    const double cost = GraphCost(graph);
    Options options;
    options.settings = {{name, value}};
    EXPECT_THAT(MessageOf([&] { Optimize(&graph, options); }), HasSubstr(name));
    EXPECT_EQ(GraphCost(graph), cost) << name;
  }
}

}  // namespace
}  // namespace gmapping_spa::ceres_backend
