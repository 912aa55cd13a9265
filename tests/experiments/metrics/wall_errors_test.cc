// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/wall_errors.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/hand_made_building.h"

namespace gmapping_spa::metrics::wall_errors_test {
namespace {

using map::TrinaryMap;

constexpr double kTolerance_m = 0.1;

WallErrors ErrorsOf(const TrinaryMap& map, const TrinaryMap& truth = Building(),
                    const backend::SE2& truth_T_map = {}) {
  const MapComparison comparison = CompareWithBuilding(map, truth, truth_T_map);
  return FindWallErrors(comparison, FindGhostWalls(comparison, kTolerance_m), kTolerance_m);
}

void ExpectWhole(const WallErrors& errors) {
  EXPECT_EQ(errors.missing_walls, 0);
  EXPECT_EQ(errors.broken_walls, 0);
  EXPECT_EQ(errors.gaps, 0);
  EXPECT_EQ(errors.gaps_m, 0.0);
  EXPECT_EQ(errors.doubled_walls, 0);
  EXPECT_EQ(errors.doubled_walls_m, 0.0);
}

TEST(WallErrors, OfTheTruthAreNoneInAnyGrid) {
  for (const double truth_m : {0.05, 0.025}) {
    for (const double map_m : {0.05, 0.025}) {
      SCOPED_TRACE(testing::Message() << truth_m << ' ' << map_m);
      const WallErrors errors = ErrorsOf(Building(map_m), Building(truth_m));
      ExpectWhole(errors);
      // Six outer walls, of which that above and that below meet the inner wall; its four sides;
      // four of the pillar. The ends of the inner wall are too short.
      EXPECT_EQ(errors.walls, 6 + 4 + 4);
    }
  }
  // 40 m, less 0.1 m at both ends of each and what the pillar and the inner wall hide.
  EXPECT_LE(ErrorsOf(Building()).walls_m, 40.0 - 14 * 0.2);
  EXPECT_GT(ErrorsOf(Building()).walls_m, 35.0);
}

TEST(WallErrors, AHoleMakesAWallBroken) {
  // 0.8 m of the left wall; cells at both ends cover 0.1 m each.
  const WallErrors errors = ErrorsOf(Without(Building(), {0.9, 3.0, 1.0, 3.8}));
  EXPECT_EQ(errors.broken_walls, 1);
  EXPECT_EQ(errors.gaps, 1);
  EXPECT_NEAR(errors.gaps_m, 0.6, 1e-6);
  EXPECT_EQ(errors.missing_walls, 0);
  TrinaryMap twice = Without(Building(), {0.9, 3.0, 1.0, 3.8});
  twice = Without(twice, {0.9, 5.0, 1.0, 5.8});
  EXPECT_EQ(ErrorsOf(twice).broken_walls, 1) << "one wall";
  EXPECT_EQ(ErrorsOf(twice).gaps, 2);
}

TEST(WallErrors, ASmallHoleIsNoGap) {
  ExpectWhole(ErrorsOf(Without(Building(), {0.9, 3.0, 1.0, 3.3})));
}

TEST(WallErrors, AWallOfWhichHalfIsErasedIsMissingAndNotBroken) {
  const WallErrors errors = ErrorsOf(Without(Building(), {0.9, 2.0, 1.0, 6.8}));
  EXPECT_EQ(errors.missing_walls, 1);
  EXPECT_EQ(errors.broken_walls, 0);
  EXPECT_EQ(errors.gaps, 0);
  EXPECT_EQ(ErrorsOf(Without(Building(), kPillar)).missing_walls, 4);
}

TEST(WallErrors, AWallDrawnTwiceIsWholeAndDoubled) {
  for (const double resolution_m : {0.05, 0.025}) {
    SCOPED_TRACE(resolution_m);
    const TrinaryMap truth = Building(resolution_m);
    // 3 m of the left wall, once more in the room and once more behind it.
    for (const double right_m : {0.2, -0.2}) {
      const WallErrors errors =
          ErrorsOf(DrawnTwice(truth, {0.9, 2.0, 1.0, 5.0}, right_m, 0.0), truth);
      EXPECT_EQ(errors.doubled_walls, 1) << right_m;
      EXPECT_NEAR(errors.doubled_walls_m, 3.1, 0.11) << "bands see two cells along the wall";
      EXPECT_EQ(errors.missing_walls + errors.broken_walls, 0);
    }
  }
}

TEST(WallErrors, AWallThatCrossesAnotherIsNotDoubled) {
  TrinaryMap map = Building();
  Fill(18, 60, 40, 61, map::CellState::kOccupied, &map);
  EXPECT_EQ(ErrorsOf(map).doubled_walls, 0);
}

TEST(WallErrors, AMapThatIsShiftedAsAWholeHasAllWalls) {
  ExpectWhole(ErrorsOf(Building(), Building(), {0.08, -0.06, 0.0}));
}

TEST(WallErrors, AShiftedWallIsNotMissing) {
  const Box left{0.9, 0.9, 1.0, 7.1};
  ExpectWhole(ErrorsOf(Without(DrawnTwice(Building(), left, 0.3, 0.0), left)));
}

TEST(WallErrors, OfAnEmptyMapAreAllMissing) {
  const WallErrors errors = ErrorsOf(UnknownMap(5, 5));
  EXPECT_EQ(errors.missing_walls, errors.walls);
}

}  // namespace
}  // namespace gmapping_spa::metrics::wall_errors_test
