// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/robust_optimization.h"

#include <gtest/gtest.h>

#include "backend/cost/graph_cost.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize_safely.h"
#include "tests/backend/outlier_graph.h"
#include "tests/built_back_ends.h"

namespace gmapping_spa::backend::robust_optimization_test {
namespace {

// Information matrices are about 100 to 1000: noise of 0.03 is what they promise.
constexpr RandomGraphOptions kGoodGraph = {
    .nodes = 60, .loop_closures = 60, .measurement_noise = 0.03, .pose_noise = 0.5};

Options Mixture() {
  Options options;
  options.loss.kind = LossKind::kMixture;
  return options;
}

TEST(OptimizeRobustly, IsLeastSquaresWhenEveryClosureIsRight) {
  for (const char* name : Built({"spa", "ceres"})) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      PoseGraph plain = RandomGraph(seed, kGoodGraph), robust = plain;
      const Summary expected = OptimizeSafely({}, LoadOptimizer(name).get(), &plain);
      const Summary summary = OptimizeRobustly(Mixture(), LoadOptimizer(name).get(), &robust);
      EXPECT_EQ(summary.final_cost, expected.final_cost) << name << " " << seed;
      EXPECT_EQ(LargestDistance(plain, robust), 0.0) << name << " " << seed;
      EXPECT_EQ(summary.edge_weights, std::vector<double>(robust.edges.size(), 1.0));
    }
  }
}

TEST(OptimizeRobustly, TellsWrongClosuresFromRightOnes) {
  constexpr int kWrong = 40;
  for (const char* name : Built({"spa", "ceres"})) {
    const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(name);
    for (unsigned seed = 0; seed < 10; ++seed) {
      PoseGraph clean = RandomGraph(seed, kGoodGraph);
      PoseGraph spoiled = OutlierGraph(seed, kWrong, kGoodGraph);
      OptimizeSafely({}, optimizer.get(), &clean);
      const Summary summary = OptimizeRobustly(Mixture(), optimizer.get(), &spoiled);
      EXPECT_EQ(summary.termination, Termination::kConverged);
      EXPECT_LT(LargestDistance(clean, spoiled), 1e-3) << name << " " << seed;
      ASSERT_EQ(summary.edge_weights.size(), spoiled.edges.size());
      for (std::size_t k = 0; k < spoiled.edges.size(); ++k) {
        EXPECT_EQ(summary.edge_weights[k] > 0.5, k < clean.edges.size())
            << name << " " << seed << " " << k;
      }
    }
  }
}

// It bends by a little at each of 300 steps, so that its own error is small.
TEST(OptimizeRobustly, FindsAWrongClosureThatALongWayAbsorbs) {
  for (const char* name : Built({"spa", "ceres"})) {
    PoseGraph graph;
    for (int k = 0; k < 300; ++k) {
      graph.nodes.push_back({.id = k, .world_T_node = {1.0 * k, 0.0, 0.0}});
      if (k == 0) continue;
      graph.edges.push_back({k - 1, k, {1, 0, 0}, InformationFromSigmas(0.1, 0.03)});
    }
    graph.edges.push_back({0, 299, {}, InformationFromSigmas(0.1, 0.1), EdgeKind::kLoopClosure});
    const PoseGraph truth = graph;
    const Summary summary = OptimizeRobustly(Mixture(), LoadOptimizer(name).get(), &graph);
    EXPECT_LT(summary.edge_weights.back(), 0.5) << name;
    EXPECT_LT(LargestDistance(truth, graph), 1e-6) << name;
  }
}

TEST(OptimizeRobustly, EndsNoWorseThanItBegan) {
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer("spa");
  for (unsigned seed = 0; seed < 20; ++seed) {
    PoseGraph graph = OutlierGraph(seed, 10, {.measurement_noise = 0.5, .pose_noise = 0.3});
    const Summary summary = OptimizeRobustly(Mixture(), optimizer.get(), &graph);
    EXPECT_LE(summary.final_cost, summary.initial_cost) << seed;
  }
}

TEST(OptimizeRobustly, LeavesThePosesToABackEndThatMovesNone) {
  PoseGraph graph = OutlierGraph(1, 10, kGoodGraph);
  const PoseGraph given = graph;
  const Summary summary = OptimizeRobustly(Mixture(), LoadOptimizer("none").get(), &graph);
  EXPECT_EQ(LargestDistance(graph, given), 0.0);
  EXPECT_EQ(summary.final_cost, summary.initial_cost);
}

class FailingOptimizer : public Optimizer {
 public:
  Summary Optimize(const Options&, std::span<const Edge>, std::span<Node>) override { return {}; }
};

// Fails when dynamic covariance scaling starts for the second time.
class FailingAtTheSecondStart : public Optimizer {
 public:
  Summary Optimize(const Options& options, std::span<const Edge> edges,
                   std::span<Node> nodes) override {
    if (options.loss.kind == LossKind::kDcs && ++starts_ == 2) return {};
    return spa_->Optimize(options, edges, nodes);
  }
  int starts() const { return starts_; }

 private:
  std::unique_ptr<Optimizer> spa_ = LoadOptimizer("spa");
  int starts_ = 0;
};

TEST(OptimizeRobustly, AStartThatFailsUndoesNoOther) {
  PoseGraph clean = RandomGraph(1, kGoodGraph), graph = OutlierGraph(1, 10, kGoodGraph);
  OptimizeSafely({}, LoadOptimizer("spa").get(), &clean);
  FailingAtTheSecondStart optimizer;
  const Summary summary = OptimizeRobustly(Mixture(), &optimizer, &graph);
  EXPECT_EQ(optimizer.starts(), 2);
  EXPECT_EQ(summary.termination, Termination::kConverged);
  EXPECT_LT(LargestDistance(clean, graph), 1e-3);
}

TEST(OptimizeRobustly, FailsWithTheGivenPosesWhenTheOptimizerDoes) {
  PoseGraph graph = OutlierGraph(1, 10, kGoodGraph);
  const PoseGraph given = graph;
  FailingOptimizer optimizer;
  EXPECT_EQ(OptimizeRobustly(Mixture(), &optimizer, &graph).termination, Termination::kFailure);
  EXPECT_EQ(LargestDistance(graph, given), 0.0);
}

}  // namespace
}  // namespace gmapping_spa::backend::robust_optimization_test
