// SPDX-License-Identifier: BSD-3-Clause
// The example back end, built against the installed package, next to spa.
#include <gtest/gtest.h>

#include "backend/cost/graph_cost.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize_safely.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend {
namespace {

TEST(DenseGaussNewton, IsFoundByItsNameAndByItsPath) {
  const std::vector<BackendDescription> found = ListBackends({EXAMPLE_FOLDER});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "dense_gauss_newton");
  EXPECT_TRUE(found[0].loadable);
  EXPECT_NE(LoadOptimizer(found[0].path), nullptr);
}

TEST(DenseGaussNewton, ReachesTheMinimumThatSpaReaches) {
  const std::unique_ptr<Optimizer> example = LoadOptimizer("dense_gauss_newton", {EXAMPLE_FOLDER});
  const std::unique_ptr<Optimizer> spa = LoadOptimizer("spa");
  for (unsigned seed = 0; seed < 10; ++seed) {
    PoseGraph graph = RandomGraph(seed), same = graph;
    const Summary summary = OptimizeSafely({}, example.get(), &graph);
    EXPECT_EQ(summary.termination, Termination::kConverged);
    const double expected = OptimizeSafely({}, spa.get(), &same).final_cost;
    EXPECT_NEAR(GraphCost(graph), expected, 1e-6 * expected);
  }
}

}  // namespace
}  // namespace gmapping_spa::backend
