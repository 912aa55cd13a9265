// The example back end, built against the installed package, next to spa.
#include <gtest/gtest.h>

#include "backend/cost/graph_cost.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize_safely.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend {
namespace {

TEST(DenseGaussNewton, ReachesTheMinimumThatSpaReaches) {
  const std::unique_ptr<Optimizer> example = LoadOptimizer(EXAMPLE_LIBRARY);
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
