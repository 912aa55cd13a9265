// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/ghost_walls.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/hand_made_building.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

std::vector<GhostWall> GhostsOf(const TrinaryMap& map, const TrinaryMap& truth = Building(),
                                const backend::SE2& truth_T_map = {}) {
  return FindGhostWalls(CompareWithBuilding(map, truth, truth_T_map), 0.1);
}

TEST(GhostWalls, OfTheTruthAreNoneInAnyGrid) {
  for (const double truth_m : {0.05, 0.025}) {
    for (const double map_m : {0.05, 0.025}) {
      EXPECT_TRUE(GhostsOf(Building(map_m), Building(truth_m)).empty()) << truth_m << map_m;
    }
  }
}

TEST(GhostWalls, OfAWallDrawnTwiceAreItsCopyOnce) {
  for (const double resolution_m : {0.05, 0.025}) {
    const TrinaryMap truth = Building(resolution_m);
    // In the room and behind the wall.
    for (const double right_m : {0.2, -0.2}) {
      SCOPED_TRACE(testing::Message() << resolution_m << ' ' << right_m);
      const auto ghosts = GhostsOf(DrawnTwice(truth, {0.9, 2.0, 1.0, 5.0}, right_m, 0.0), truth);
      ASSERT_EQ(ghosts.size(), 1U);
      EXPECT_NEAR(ghosts[0].length_m, 3.0, 0.06);
      for (const Eigen::Vector2d& point : ghosts[0].points) {
        EXPECT_NEAR(point.x(), 0.975 + right_m, 0.026);
      }
    }
  }
}

TEST(GhostWalls, CountOnceHoweverThickAndWithHolesOfOneCell) {
  TrinaryMap map = Building();
  Fill(40, 60, 80, 63, CellState::kOccupied, &map);
  for (int column = 42; column < 78; column += 5) {
    Fill(column, 60, column + 1, 63, CellState::kFree, &map);
  }
  const auto ghosts = GhostsOf(map);
  ASSERT_EQ(ghosts.size(), 1U);
  EXPECT_NEAR(ghosts[0].length_m, 2.0, 0.15) << "thinned at both ends";
}

TEST(GhostWalls, OfTwoPlacesAreTwo) {
  TrinaryMap map = Building();
  Fill(40, 60, 60, 61, CellState::kOccupied, &map);
  Fill(40, 100, 50, 101, CellState::kOccupied, &map);
  const auto ghosts = GhostsOf(map);
  ASSERT_EQ(ghosts.size(), 2U);
  EXPECT_NEAR(ghosts[0].length_m, 1.0, 1e-9);
  EXPECT_NEAR(ghosts[1].length_m, 0.5, 1e-9);
}

TEST(GhostWalls, GoRoundCorners) {
  TrinaryMap map = Building();
  Fill(40, 60, 60, 61, CellState::kOccupied, &map);
  Fill(40, 60, 41, 70, CellState::kOccupied, &map);
  const auto ghosts = GhostsOf(map);
  ASSERT_EQ(ghosts.size(), 1U);
  EXPECT_NEAR(ghosts[0].length_m, 1.45, 0.06);
}

TEST(GhostWalls, MayBeSlanted) {
  TrinaryMap map = Building();
  for (int i = 0; i < 30; ++i) map.at(35 + i, 60 + i) = CellState::kOccupied;
  const auto ghosts = GhostsOf(map);
  ASSERT_EQ(ghosts.size(), 1U);
  EXPECT_NEAR(ghosts[0].length_m, 1.5 * std::sqrt(2.0), 0.05);
}

TEST(GhostWalls, AreNoSpecks) {
  TrinaryMap map = Building();
  Fill(40, 60, 45, 61, CellState::kOccupied, &map);  // 0.25 m
  EXPECT_TRUE(GhostsOf(map).empty());
}

TEST(GhostWalls, AreNotMadeByASmallShiftOfAllNorByAWallThatStandsElsewhere) {
  EXPECT_TRUE(GhostsOf(Building(), Building(), {0.1, -0.1, 0.0}).empty());
  const Box left{0.9, 0.9, 1.0, 7.1};
  for (const double right_m : {0.3, -0.3}) {
    EXPECT_TRUE(GhostsOf(Without(DrawnTwice(Building(), left, right_m, 0.0), left)).empty());
  }
}

TEST(GhostWalls, AreNoRoomsThatWereNeverSeen) {
  // Only the left room is seen, the right one drawn as it is.
  const TrinaryMap truth = Building();
  const backend::Trajectory poses = {{0.0, {2.0, 2.0, 0.0}}};
  const auto comparison = CompareMaps(truth, LookAround(truth, poses, 30.0), truth, {});
  EXPECT_TRUE(FindGhostWalls(comparison, 0.1).empty());
}

TEST(GhostWalls, OfAnEmptyMapAreNone) { EXPECT_TRUE(GhostsOf(UnknownMap(5, 5)).empty()); }

}  // namespace
}  // namespace gmapping_spa::metrics
