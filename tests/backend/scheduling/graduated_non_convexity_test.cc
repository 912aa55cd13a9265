// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/graduated_non_convexity.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "backend/cost/graph_cost.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize_safely.h"
#include "tests/backend/outlier_graph.h"
#include "tests/built_back_ends.h"

namespace gmapping_spa::backend::graduated_non_convexity_test {
namespace {

constexpr RandomGraphOptions kGoodGraph = {
    .nodes = 60, .loop_closures = 60, .measurement_noise = 0.02, .pose_noise = 0.5};

Options Truncated() {
  Options options;
  options.loss = {LossKind::kTruncated, 4.0};
  return options;
}

TEST(OptimizeGradually, GivesWrongLoopClosuresNoSay) {
  for (const char* name : Built({"spa", "ceres"})) {
    const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(name);
    for (unsigned seed = 0; seed < 5; ++seed) {
      PoseGraph clean = RandomGraph(seed, kGoodGraph);
      PoseGraph spoiled = OutlierGraph(seed, 15, kGoodGraph);
      OptimizeSafely({}, optimizer.get(), &clean);
      const Summary summary = OptimizeGradually(Truncated(), optimizer.get(), &spoiled);
      EXPECT_EQ(summary.termination, Termination::kConverged);
      EXPECT_EQ(summary.final_cost, GraphCost(spoiled, Truncated().loss));
      EXPECT_LT(LargestDistance(clean, spoiled), 0.1) << name << " " << seed;
    }
  }
}

TEST(OptimizeGradually, EndsNoWorseThanItBegan) {
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer("spa");
  for (unsigned seed = 0; seed < 20; ++seed) {
    PoseGraph graph = RandomGraph(seed, {.measurement_noise = 0.5, .pose_noise = 0.3});
    const double initial_cost = GraphCost(graph, Truncated().loss);
    const Summary summary = OptimizeGradually(Truncated(), optimizer.get(), &graph);
    EXPECT_EQ(summary.initial_cost, initial_cost);
    EXPECT_LE(GraphCost(graph, Truncated().loss), initial_cost);
  }
}

TEST(OptimizeGradually, NeedsTheTruncatedLoss) {
  PoseGraph graph = RandomGraph(1);
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer("none");
  EXPECT_THROW(OptimizeGradually({}, optimizer.get(), &graph), std::invalid_argument);
}

}  // namespace
}  // namespace gmapping_spa::backend::graduated_non_convexity_test
