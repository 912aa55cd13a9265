// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/corner_errors.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/hand_made_building.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

CornerErrors ErrorsOf(const TrinaryMap& map, const TrinaryMap& truth = Building()) {
  return FindCornerErrors(truth, CompareWithBuilding(map, truth), 0.1);
}

TEST(CornerErrors, OfTheTruthAreNoneInAnyGrid) {
  for (const double truth_m : {0.05, 0.025}) {
    for (const double map_m : {0.05, 0.025}) {
      SCOPED_TRACE(testing::Message() << truth_m << ' ' << map_m);
      const CornerErrors errors = ErrorsOf(Building(map_m), Building(truth_m));
      // Of the rooms four, four where the inner wall meets the others and at the door, four of the
      // pillar; the two corners of an end of the inner wall may be one.
      EXPECT_GE(errors.in_sight.size(), 4U + 2U + 2U + 4U);
      EXPECT_LE(errors.in_sight.size(), 4U + 4U + 4U + 4U);
      EXPECT_EQ(errors.found, static_cast<int>(errors.in_sight.size()));
      EXPECT_TRUE(errors.false_ones.empty());
    }
  }
}

TEST(CornerErrors, AnErasedPillarTakesItsFour) {
  const CornerErrors errors = ErrorsOf(Without(Building(), kPillar));
  EXPECT_EQ(static_cast<int>(errors.in_sight.size()) - errors.found, 4);
  EXPECT_TRUE(errors.false_ones.empty());
}

TEST(CornerErrors, ABoxThatIsNotThereHasFalseOnes) {
  TrinaryMap map = Building();
  Fill(40, 60, 52, 72, CellState::kOccupied, &map);
  Fill(41, 61, 51, 71, CellState::kUnknown, &map);
  const CornerErrors errors = ErrorsOf(map);
  EXPECT_EQ(errors.false_ones.size(), 4U);
  EXPECT_EQ(errors.found, static_cast<int>(errors.in_sight.size()));
}

TEST(CornerErrors, ARoomThatWasNeverSeenHasNoneInSight) {
  const TrinaryMap truth = Building();
  const backend::Trajectory poses = {{0.0, {2.0, 2.0, 0.0}}};
  const auto comparison =
      CompareMaps(truth, LookAround(truth, poses, 30.0), Without(truth, {5.0, 0.0, 10.0, 8.0}), {});
  const CornerErrors errors = FindCornerErrors(truth, comparison, 0.1);
  EXPECT_EQ(errors.found, static_cast<int>(errors.in_sight.size()));
  for (const Eigen::Vector2d& corner : errors.in_sight) EXPECT_LT(corner.x(), 5.2);
}

}  // namespace
}  // namespace gmapping_spa::metrics
