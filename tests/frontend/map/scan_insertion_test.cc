// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/scan_insertion.h"

#include <gtest/gtest.h>

#include <numbers>

namespace gmapping_spa::map {
namespace {

using backend::SE2;
using sensor::BeamStatus;

constexpr double kQuarterTurn = std::numbers::pi / 2;

OccupancyGrid Grid() { return OccupancyGrid({.resolution_m = 0.1}); }

sensor::LaserScan OneBeam(double angle_rad, double range_m, BeamStatus status) {
  sensor::LaserScan scan;
  scan.beams = {{angle_rad, range_m, status}};
  return scan;
}

TEST(InsertScan, CountsAHitAtTheEndAndPassesOnTheWay) {
  OccupancyGrid grid = Grid();
  InsertScan(OneBeam(0.0, 1.0, BeamStatus::kHit), {0.05, 0.05, 0.0}, {}, &grid);
  for (int x = 0; x < 10; ++x) {
    EXPECT_EQ(grid.cell({x, 0}).visits, 1) << x;
    EXPECT_EQ(grid.cell({x, 0}).hits, 0) << x;
  }
  EXPECT_EQ(grid.cell({10, 0}).visits, 1);
  EXPECT_EQ(grid.cell({10, 0}).hits, 1);
  EXPECT_EQ(grid.cell({11, 0}).visits, 0);
}

TEST(InsertScan, TheMarginBeforeAHitIsNotCleared) {
  OccupancyGrid grid = Grid();
  InsertScan(OneBeam(0.0, 1.0, BeamStatus::kHit), {0.05, 0.05, 0.0}, {.clear_margin_m = 0.3},
             &grid);
  for (int x = 0; x < 10; ++x) EXPECT_EQ(grid.cell({x, 0}).visits, x < 7 ? 1 : 0) << x;
  EXPECT_EQ(grid.cell({10, 0}).hits, 1);
  // A margin longer than the beam clears nothing, and nothing behind the laser.
  OccupancyGrid near = Grid();
  InsertScan(OneBeam(0.0, 0.2, BeamStatus::kHit), {0.05, 0.05, 0.0}, {.clear_margin_m = 0.3},
             &near);
  for (int x = -3; x < 2; ++x) EXPECT_EQ(near.cell({x, 0}).visits, 0) << x;
  EXPECT_EQ(near.cell({2, 0}).hits, 1);
}

TEST(InsertScan, HonoursThePoseOfTheRobotAndTheMountingOfTheLaser) {
  OccupancyGrid grid = Grid();
  sensor::LaserScan scan = OneBeam(kQuarterTurn, 1.0, BeamStatus::kHit);
  scan.robot_T_laser = {0.5, 0.2, -kQuarterTurn};
  // Robot faces up: the laser is at (-0.15, 0.55), faces right; its beam goes up.
  InsertScan(scan, {0.05, 0.05, kQuarterTurn}, {}, &grid);
  EXPECT_EQ(grid.cell({-2, 15}).hits, 1);
  EXPECT_EQ(grid.cell({-2, 14}).visits, 1);
  EXPECT_EQ(grid.cell({-2, 5}).visits, 1);
  EXPECT_EQ(grid.cell({-2, 4}).visits, 0);
  EXPECT_EQ(grid.cell({0, 0}).visits, 0);
}

TEST(InsertScan, KeepsTheMeanOfTheHitsWithinACell) {
  OccupancyGrid grid = Grid();
  sensor::LaserScan scan = OneBeam(0.0, 1.02, BeamStatus::kHit);
  scan.beams.push_back({0.0, 1.06, BeamStatus::kHit});
  InsertScan(scan, {0.0, -0.03, 0.0}, {}, &grid);
  const Cell& cell = grid.cell({10, -1});
  ASSERT_EQ(cell.hits, 2);
  EXPECT_NEAR(cell.mean_x, 0.4 * Cell::kMeanScale, 2);
  EXPECT_NEAR(cell.mean_y, 0.7 * Cell::kMeanScale, 2);
}

TEST(InsertScan, NoReturnClearsOnlyWhenAskedTo) {
  const sensor::LaserScan scan = OneBeam(0.0, 1.0, BeamStatus::kNoReturn);
  OccupancyGrid grid = Grid();
  InsertScan(scan, {0.05, 0.05, 0.0}, {.no_return_clears = false}, &grid);
  EXPECT_EQ(grid.CountTiles(), 0u);
  InsertScan(scan, {0.05, 0.05, 0.0}, {.no_return_clears = true}, &grid);
  for (int x = 0; x < 10; ++x) EXPECT_EQ(grid.cell({x, 0}).visits, 1) << x;
  EXPECT_EQ(grid.cell({10, 0}).visits, 0);  // the end itself says nothing
}

TEST(InsertScan, InvalidBeamsLeaveNoTrace) {
  OccupancyGrid grid = Grid();
  InsertScan(OneBeam(0.0, 0.0, BeamStatus::kInvalid), {}, {.no_return_clears = true}, &grid);
  EXPECT_EQ(grid.CountTiles(), 0u);
}

}  // namespace
}  // namespace gmapping_spa::map
