// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/lifted_bound.h"

#include <gtest/gtest.h>

#include "backend/certificate/lifted_descent.h"
#include "backend/cost/graph_cost.h"
#include "backend/spa/spa_optimizer.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend::lifted_bound_test {
namespace {

TEST(LiftedBound, IsBelowTheCostOfAllPosesAndNearTheLowestWhereErrorsAreSmall) {
  for (const double noise : {0.02, 0.5}) {
    PoseGraph graph = RandomGraph(9, {.measurement_noise = noise});
    for (Edge& edge : graph.edges) edge.information = InformationFromSigmas(0.1, 0.1);
    spa::GraphStructure structure;
    structure.Update(IndexGraph(graph));
    std::vector<InformationSplit> splits;
    for (const Edge& edge : graph.edges) splits.push_back(SplitInformation(edge.information));
    const ChordalCost cost(graph, structure, splits);
    LiftedPoses lifted = LiftPoses(PosesOf(graph), 2);
    LiftedSolver solver;
    const double first = LiftedBound(structure, cost, lifted, 1e-12, &solver);
    LiftedDescent(structure, cost).Minimize({.cost_tolerance = 1e-9}, &lifted);
    const double last = LiftedBound(structure, cost, lifted, 1e-12, &solver);
    spa::SpaOptimizer optimizer;
    optimizer.Optimize({}, graph.edges, graph.nodes);
    const double least = GraphCost(graph);
    EXPECT_LE(first, least);
    EXPECT_LE(last, least);
    EXPECT_GE(first, 0.0);
    EXPECT_GT(last, (noise < 0.1 ? 0.99 : 0.1) * least);
  }
}

}  // namespace
}  // namespace gmapping_spa::backend::lifted_bound_test
