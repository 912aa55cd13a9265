// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/object_errors.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/experiments/metrics/hand_made_building.h"

namespace gmapping_spa::metrics::object_errors_test {
namespace {

using map::CellState;
using map::TrinaryMap;

// The pillar alone, unknown where there are walls without it.
TrinaryMap Pillar(double resolution_m = 0.05) {
  TrinaryMap objects = Building(resolution_m);
  const TrinaryMap without = Building(resolution_m, /*with_pillar=*/false);
  for (std::size_t i = 0; i < objects.cells.size(); ++i) {
    if (without.cells[i] == CellState::kOccupied) objects.cells[i] = CellState::kUnknown;
  }
  return objects;
}

std::vector<ObjectErrors> ErrorsOf(const TrinaryMap& map, double resolution_m = 0.05) {
  const TrinaryMap truth = Building(resolution_m);
  return FindObjectErrors(truth, Pillar(resolution_m), CompareWithBuilding(map, truth), 0.1);
}

TEST(ObjectErrors, OfTheTruthAreNoneInAnyGrid) {
  for (const double truth_m : {0.05, 0.025}) {
    for (const double map_m : {0.05, 0.025}) {
      const auto objects = ErrorsOf(Building(map_m), truth_m);
      ASSERT_EQ(objects.size(), 1U);
      EXPECT_NEAR(objects[0].center.x(), 7.1, 1e-9);
      EXPECT_NEAR(objects[0].center.y(), 4.1, 1e-9);
      EXPECT_NEAR(objects[0].surface_m, 4 * 0.6, 1e-9);
      EXPECT_TRUE(objects[0].is_there());
      EXPECT_EQ(objects[0].complete, 1.0);
      EXPECT_GE(*objects[0].width_m, map_m - 1e-9);
      EXPECT_LT(*objects[0].width_m, 0.08) << "bands beside a corner may see its other side";
    }
  }
}

TEST(ObjectErrors, AnErasedSideIsIncomplete) {
  const auto objects = ErrorsOf(Without(Building(), {6.8, 3.8, 6.85, 4.4}));
  EXPECT_TRUE(objects[0].is_there());
  // Of twelve edges, two at each end are within 0.1 m of the other sides.
  EXPECT_NEAR(*objects[0].complete, 40.0 / 48.0, 0.05);
}

TEST(ObjectErrors, AnErasedObjectIsNotThere) {
  const auto objects = ErrorsOf(Without(Building(), kPillar));
  EXPECT_FALSE(objects[0].is_there());
  EXPECT_EQ(objects[0].complete, 0.0);
  EXPECT_FALSE(objects[0].width_m);
}

TEST(ObjectErrors, AThickSideIsNotSharp) {
  TrinaryMap map = Building();
  Fill(136, 76, 140, 88, CellState::kOccupied, &map);  // four cells of the left side
  EXPECT_GT(*ErrorsOf(map)[0].width_m, 0.05 + 0.1 / 4.0);
}

TEST(ObjectErrors, AnObjectThatWasNeverSeenHasNone) {
  const TrinaryMap truth = Building();
  const backend::Trajectory poses = {{0.0, {2.0, 2.0, 0.0}}};
  const auto objects = FindObjectErrors(
      truth, Pillar(), CompareMaps(truth, LookAround(truth, poses, 30.0), truth, {}), 0.1);
  EXPECT_EQ(objects[0].surface_m, 0.0);
  EXPECT_FALSE(objects[0].complete);
  EXPECT_FALSE(objects[0].is_there());
}

TEST(ObjectErrors, ObjectsMustStandInTheTruth) {
  const TrinaryMap truth = Building();
  const MapComparison comparison = CompareWithBuilding(truth);
  EXPECT_THROW(FindObjectErrors(truth, Pillar(0.025), comparison, 0.1), std::runtime_error);
  TrinaryMap elsewhere = Pillar();
  elsewhere.at(50, 50) = CellState::kOccupied;
  EXPECT_THROW(FindObjectErrors(truth, elsewhere, comparison, 0.1), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::metrics::object_errors_test
