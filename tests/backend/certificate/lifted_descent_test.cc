// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/lifted_descent.h"

#include <gtest/gtest.h>

#include "backend/graph/initial_guess.h"
#include "tests/backend/certificate/wound_ring.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend::lifted_descent_test {
namespace {

struct Lifted {
  explicit Lifted(PoseGraph the_graph) : graph(std::move(the_graph)) {
    structure.Update(IndexGraph(graph));
    for (const Edge& edge : graph.edges) splits.push_back(SplitInformation(edge.information));
  }
  PoseGraph graph;
  spa::GraphStructure structure;
  std::vector<InformationSplit> splits;
};

TEST(LiftedDescent, UnwindsARingThroughAnotherDimension) {
  const Lifted ring(WoundRing(20, 2));
  const ChordalCost cost(ring.graph, ring.structure, ring.splits);
  LiftedDescent descent(ring.structure, cost);
  // In the plane, it stays where it is.
  LiftedPoses flat = LiftPoses(PosesOf(ring.graph), 1);
  EXPECT_GT(descent.Minimize({}, &flat), 10.0);
  LiftedPoses poses = LiftPoses(PosesOf(ring.graph), 2);
  for (Eigen::Index row = 3; row < poses.rows(); row += 2) {
    poses(row, 1) = 0.3 * std::polar(1.0, 0.1 * static_cast<double>(row));
    poses.row(row).normalize();
  }
  const double least = descent.Minimize({.cost_tolerance = 1e-8}, &poses);
  EXPECT_LT(least, 1e-3);
  for (Eigen::Index row = 1; row < poses.rows(); row += 2) {
    EXPECT_NEAR(poses.row(row).norm(), 1.0, 1e-12);
  }
  std::vector<SE2> rounded = PosesOf(ring.graph);
  ASSERT_TRUE(RoundPoses(ring.graph, ring.structure, poses, &rounded));
  const PoseGraph right = WoundRing(20, 1);
  for (std::size_t k = 0; k < rounded.size(); ++k) {
    EXPECT_LT(Minus(rounded[k], right.nodes[k].world_T_node).norm(), 0.1) << k;
  }
}

TEST(LiftedDescent, TakesNoStepWithoutProducts) {
  const Lifted random(RandomGraph(2));
  const ChordalCost cost(random.graph, random.structure, random.splits);
  LiftedPoses poses = LiftPoses(PosesOf(random.graph), 2);
  const LiftedPoses before = poses;
  LiftedDescent(random.structure, cost).Minimize({.max_products = 0}, &poses);
  EXPECT_EQ(poses, before);
}

TEST(LiftedDescent, RoundsPosesToThemselvesWhereMeasurementsAreRight) {
  const Lifted random(RandomGraph(3, {.measurement_noise = 0.0}));
  std::vector<SE2> truth = PosesOf(random.graph);
  InitializeFromOdometry(random.graph, random.structure.index(), &truth);
  std::vector<SE2> rounded = PosesOf(random.graph);
  ASSERT_TRUE(RoundPoses(random.graph, random.structure, LiftPoses(truth, 2), &rounded));
  for (std::size_t k = 0; k < truth.size(); ++k) {
    EXPECT_LT(Minus(rounded[k], truth[k]).norm(), 1e-9) << k;
  }
}

}  // namespace
}  // namespace gmapping_spa::backend::lifted_descent_test
