// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/optimize_safely.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "backend/cost/graph_cost.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend {
namespace {

using ::testing::HasSubstr;

// Does what the test says.
class ScriptedOptimizer : public Optimizer {
 public:
  using Script = std::function<Summary(std::span<Node>)>;
  explicit ScriptedOptimizer(Script script) : script_(std::move(script)) {}
  Summary Optimize(const Options&, std::span<const Edge>, std::span<Node> nodes) override {
    return script_(nodes);
  }

 private:
  Script script_;
};

Summary Converged() {
  Summary summary;
  summary.termination = Termination::kConverged;
  return summary;
}

// Checks that the script is called a failure for `reason`, and that it leaves no trace.
void ExpectContained(const ScriptedOptimizer::Script& script, const char* reason) {
  ScriptedOptimizer optimizer(script);
  PoseGraph graph = RandomGraph(3);
  const PoseGraph before = graph;
  const Summary summary = OptimizeSafely({}, &optimizer, &graph);
  EXPECT_EQ(summary.termination, Termination::kFailure);
  EXPECT_THAT(summary.message, HasSubstr(reason));
  EXPECT_EQ(summary.initial_cost, GraphCost(before));
  EXPECT_EQ(summary.final_cost, summary.initial_cost);
  for (std::size_t k = 0; k < before.nodes.size(); ++k) {
    EXPECT_EQ(graph.nodes[k].id, before.nodes[k].id);
    EXPECT_EQ(graph.nodes[k].world_T_node, before.nodes[k].world_T_node);
  }
}

TEST(OptimizeSafely, ContainsWhatIsThrown) {
  ExpectContained(
      [](std::span<Node> nodes) -> Summary {
        nodes[1].world_T_node.x = 1e9;
        throw std::runtime_error("out of cheese");
      },
      "out of cheese");
  ExpectContained([](std::span<Node>) -> Summary { throw 42; }, "unknown type");
}

TEST(OptimizeSafely, RejectsPosesThatAreNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ExpectContained(
        [bad](std::span<Node> nodes) {
          nodes.back().world_T_node.theta = bad;
          return Converged();
        },
        "not finite");
  }
}

TEST(OptimizeSafely, RejectsWorsePoses) {
  ExpectContained(
      [](std::span<Node> nodes) {
        nodes[5].world_T_node.y += 10.0;
        return Converged();
      },
      "poses that cost");
}

TEST(OptimizeSafely, RejectsMovingAFixedNode) {
  ExpectContained(
      [](std::span<Node> nodes) {
        // The whole graph moves, at the same cost.
        for (Node& node : nodes) node.world_T_node = SE2{1, 2, 3} * node.world_T_node;
        return Converged();
      },
      "fixed");
}

TEST(OptimizeSafely, RejectsChangingMoreThanPoses) {
  ExpectContained(
      [](std::span<Node> nodes) {
        nodes[2].id = 77;
        return Converged();
      },
      "more of node");
}

TEST(OptimizeSafely, UndoesAReportedFailure) {
  ExpectContained(
      [](std::span<Node> nodes) {
        nodes[2].world_T_node.x += 1e-3;
        Summary summary;
        summary.message = "gave up";
        return summary;
      },
      "gave up");
}

TEST(OptimizeSafely, RecomputesTheCostsOfAGoodResult) {
  PoseGraph graph = RandomGraph(3, {.measurement_noise = 0.0});
  const std::vector<SE2> truth =
      PosesOf(RandomGraph(3, {.measurement_noise = 0.0, .pose_noise = 0.0}));
  ScriptedOptimizer optimizer([&](std::span<Node> nodes) {
    const SE2 aligned = nodes[0].world_T_node * Inverse(truth[0]);
    for (std::size_t k = 1; k < nodes.size(); ++k) nodes[k].world_T_node = aligned * truth[k];
    Summary summary = Converged();
    summary.initial_cost = summary.final_cost = -1.0;
    return summary;
  });
  const double initial_cost = GraphCost(graph);
  const Summary summary = OptimizeSafely({}, &optimizer, &graph);
  EXPECT_EQ(summary.termination, Termination::kConverged);
  EXPECT_EQ(summary.initial_cost, initial_cost);
  EXPECT_LT(summary.final_cost, initial_cost);
  EXPECT_EQ(summary.final_cost, GraphCost(graph));
}

// What an optimizer was told.
class RecordingOptimizer : public Optimizer {
 public:
  void CheckOptions(const Options& options) const override {
    if (!options.settings.empty()) throw std::runtime_error("it has no settings");
  }
  Summary Optimize(const Options& options, std::span<const Edge>, std::span<Node> nodes) override {
    told = options.initialization;
    start = {nodes.begin(), nodes.end()};
    return Converged();
  }
  Initialization told = Initialization::kAuto;
  std::vector<Node> start;
};

TEST(OptimizeSafely, InitializesForTheOptimizer) {
  PoseGraph graph = RandomGraph(3, {.measurement_noise = 0.01, .pose_noise = 2.0});
  const auto expected = InitialPoses(Initialization::kSpanningTree, graph, IndexGraph(graph));
  RecordingOptimizer optimizer;
  Options options;
  options.initialization = Initialization::kSpanningTree;
  const Summary summary = OptimizeSafely(options, &optimizer, &graph);
  EXPECT_EQ(optimizer.told, Initialization::kKeep);
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
    EXPECT_EQ(optimizer.start[k].world_T_node, expected.value()[k]);
  }
  EXPECT_EQ(summary.final_cost, GraphCost(graph, IndexGraph(graph), *expected));
}

TEST(OptimizeSafely, KeepsGivenPosesThatCostLessThanWhatTheInitializationLeadsTo) {
  PoseGraph graph = RandomGraph(3, {.measurement_noise = 0.1, .pose_noise = 0.0});
  const PoseGraph before = graph;
  const auto start = InitialPoses(Initialization::kOdometry, graph, IndexGraph(graph));
  ASSERT_GT(GraphCost(graph, IndexGraph(graph), start.value()), GraphCost(graph));
  RecordingOptimizer optimizer;
  Options options;
  options.initialization = Initialization::kOdometry;
  const Summary summary = OptimizeSafely(options, &optimizer, &graph);
  EXPECT_EQ(summary.termination, Termination::kConverged);
  EXPECT_THAT(summary.message, HasSubstr("the given poses cost less and are kept"));
  EXPECT_EQ(summary.final_cost, GraphCost(before));
  EXPECT_EQ(PosesOf(graph), PosesOf(before));
}

TEST(OptimizeSafely, SaysWhereTheEdgesDoNotDetermineTheInitialization) {
  PoseGraph graph = RandomGraph(3);
  for (Edge& edge : graph.edges) edge.information.setZero();
  RecordingOptimizer optimizer;
  Options options;
  options.initialization = Initialization::kChordal;
  const Summary summary = OptimizeSafely(options, &optimizer, &graph);
  EXPECT_THAT(summary.message, HasSubstr("do not determine the initialization chordal"));
}

TEST(OptimizeSafely, RefusesOptionsThatTheOptimizerRefuses) {
  PoseGraph graph = RandomGraph(3);
  RecordingOptimizer optimizer;
  Options options;
  options.settings = {{"any", "1"}};
  const Summary summary = OptimizeSafely(options, &optimizer, &graph);
  EXPECT_EQ(summary.termination, Termination::kFailure);
  EXPECT_THAT(summary.message, HasSubstr("it has no settings"));
  EXPECT_TRUE(optimizer.start.empty());
}

}  // namespace
}  // namespace gmapping_spa::backend
