// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/wall_band.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;

// The surface is at y = 1 m, the wall below it.
constexpr double kX = 0.525, kSurface_y = 1.0;

std::optional<WallBand> BandOf(const map::TrinaryMap& map, double behind_m = 0.5,
                               double in_front_m = 0.5) {
  const std::vector<WallBand> bands = FindWallBands(
      map, {kX, kSurface_y},
      {.normal = {0.0, 1.0}, .half_length_m = 0.1, .behind_m = behind_m, .in_front_m = in_front_m});
  return bands.empty() ? std::nullopt : std::optional(bands.front());
}

// Rows [bottom, top) are occupied; row 20 is the first in front of the surface.
map::TrinaryMap WallOfRows(int bottom, int top) {
  map::TrinaryMap map = UnknownMap(40, 40);
  Fill(0, bottom, 40, top, CellState::kOccupied, &map);
  return map;
}

TEST(WallBand, OfAWallOfOneCellIsOneCellWide) {
  const auto band = BandOf(WallOfRows(19, 20));
  ASSERT_TRUE(band);
  EXPECT_NEAR(band->begin_m, -0.05, 1e-9);
  EXPECT_NEAR(band->end_m, 0.0, 1e-9);
  EXPECT_NEAR(band->distance_m(), 0.0, 1e-9);
}

TEST(WallBand, IsAsWideAsTheWallIsThick) {
  const auto band = BandOf(WallOfRows(17, 21));
  ASSERT_TRUE(band);
  EXPECT_NEAR(band->width_m(), 0.2, 1e-9);
  EXPECT_EQ(band->distance_m(), 0.0);
}

TEST(WallBand, IsAsFarAsTheWallWasMoved) {
  EXPECT_NEAR(BandOf(WallOfRows(17, 18))->distance_m(), 0.1, 1e-9);
  EXPECT_NEAR(BandOf(WallOfRows(22, 23))->distance_m(), 0.1, 1e-9);
  EXPECT_NEAR(BandOf(WallOfRows(22, 23))->width_m(), 0.05, 1e-9);
}

TEST(WallBand, IsTheNearestOfSeveral) {
  map::TrinaryMap map = WallOfRows(19, 20);
  Fill(0, 24, 40, 27, CellState::kOccupied, &map);
  EXPECT_NEAR(BandOf(map)->width_m(), 0.05, 1e-9);
  EXPECT_NEAR(BandOf(map)->distance_m(), 0.0, 1e-9);
}

TEST(WallBand, TheOthersFollowFromBehindToTheFront) {
  map::TrinaryMap map = WallOfRows(19, 20);
  Fill(0, 24, 40, 27, CellState::kOccupied, &map);
  Fill(0, 14, 40, 15, CellState::kOccupied, &map);
  const auto bands = FindWallBands(
      map, {kX, kSurface_y},
      {.normal = {0.0, 1.0}, .half_length_m = 0.1, .behind_m = 0.5, .in_front_m = 0.5});
  ASSERT_EQ(bands.size(), 3U);
  EXPECT_NEAR(bands[0].end_m, 0.0, 1e-9);
  EXPECT_NEAR(bands[1].end_m, -0.25, 1e-9);
  EXPECT_NEAR(bands[2].begin_m, 0.2, 1e-9);
}

TEST(WallBand, JoinsCellsSideBySideInTheStretch) {
  map::TrinaryMap map = UnknownMap(40, 40);
  // One cell a column, in three rows in turn, as noise leaves them.
  for (int column = 0; column < 40; ++column) {
    map.at(column, 18 + column % 3) = CellState::kOccupied;
  }
  EXPECT_NEAR(BandOf(map)->width_m(), 0.15, 1e-9);
  // Beyond the stretch of two cells to each side of column 10, nothing counts.
  Fill(0, 15, 8, 25, CellState::kOccupied, &map);
  Fill(13, 15, 40, 25, CellState::kOccupied, &map);
  EXPECT_NEAR(BandOf(map)->width_m(), 0.15, 1e-9);
}

TEST(WallBand, CoversTheStretchOnBothSides) {
  // The wall is a step higher on one side of the point than on the other.
  for (const bool left_is_higher : {false, true}) {
    map::TrinaryMap map = UnknownMap(40, 40);
    Fill(0, left_is_higher ? 20 : 19, 10, left_is_higher ? 21 : 20, CellState::kOccupied, &map);
    Fill(11, left_is_higher ? 19 : 20, 40, left_is_higher ? 20 : 21, CellState::kOccupied, &map);
    EXPECT_NEAR(BandOf(map)->width_m(), 0.1, 1e-9);
  }
}

TEST(WallBand, EndsWhereTheNextSurfaceBegins) {
  const map::TrinaryMap map = WallOfRows(0, 40);
  const auto band = BandOf(map, 0.1, 0.3);
  EXPECT_NEAR(band->begin_m, -0.1, 1e-9);
  EXPECT_NEAR(band->end_m, 0.3, 1e-9);
}

TEST(WallBand, IsNothingWhereNothingIsOccupied) {
  EXPECT_FALSE(BandOf(UnknownMap(40, 40)));
  EXPECT_FALSE(BandOf(WallOfRows(31, 32))) << "out of reach";
}

}  // namespace
}  // namespace gmapping_spa::metrics
