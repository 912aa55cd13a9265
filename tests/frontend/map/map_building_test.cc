// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/map_building.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gmapping_spa::map {
namespace {

void AddBeams(CellIndex cell, int hits, int passes, OccupancyGrid* grid) {
  for (int i = 0; i < hits; ++i) grid->AddHit(cell.x + 0.5, cell.y + 0.5);
  for (int i = 0; i < passes; ++i) grid->AddPasses(cell, {cell.x + 1, cell.y});
}

TEST(BuildTrinaryMap, OfAnEmptyGridIsEmpty) {
  const TrinaryMap map = BuildTrinaryMap(OccupancyGrid({}), 0.25);
  EXPECT_EQ(map.width, 0);
  EXPECT_EQ(map.height, 0);
  EXPECT_TRUE(map.cells.empty());
}

TEST(BuildTrinaryMap, HoldsTheKnownCellsAndNoMore) {
  OccupancyGrid grid({.resolution_m = 0.1});
  AddBeams({-21, 3}, 1, 0, &grid);
  AddBeams({14, -7}, 0, 1, &grid);
  const TrinaryMap map = BuildTrinaryMap(grid, 0.25);
  EXPECT_EQ(map.width, 36);
  EXPECT_EQ(map.height, 11);
  EXPECT_EQ(map.resolution_m, 0.1);
  EXPECT_NEAR(map.origin_x_m, -2.1, 1e-12);
  EXPECT_NEAR(map.origin_y_m, -0.7, 1e-12);
  EXPECT_EQ(map.at(0, 10), CellState::kOccupied);
  EXPECT_EQ(map.at(35, 0), CellState::kFree);
  EXPECT_EQ(std::count(map.cells.begin(), map.cells.end(), CellState::kUnknown), 36 * 11 - 2);
}

TEST(BuildTrinaryMap, HoldsASingleCell) {
  OccupancyGrid grid({});
  AddBeams({-1, -1}, 1, 0, &grid);
  const TrinaryMap map = BuildTrinaryMap(grid, 0.25);
  ASSERT_EQ(map.cells.size(), 1u);
  EXPECT_EQ(map.at(0, 0), CellState::kOccupied);
}

TEST(BuildTrinaryMap, IsOccupiedWhereMoreThanTheThresholdEnded) {
  OccupancyGrid grid({});
  AddBeams({0, 0}, 1, 4, &grid);  // 0.2
  AddBeams({1, 0}, 1, 3, &grid);  // 0.25: not more
  AddBeams({2, 0}, 26, 74, &grid);
  AddBeams({3, 0}, 0, 5, &grid);
  AddBeams({4, 0}, 5, 0, &grid);
  const auto state = [](const TrinaryMap& map, int x) { return map.at(x, 0); };
  const TrinaryMap quarter = BuildTrinaryMap(grid, 0.25);
  EXPECT_EQ(state(quarter, 0), CellState::kFree);
  EXPECT_EQ(state(quarter, 1), CellState::kFree);
  EXPECT_EQ(state(quarter, 2), CellState::kOccupied);
  EXPECT_EQ(state(quarter, 3), CellState::kFree);
  EXPECT_EQ(state(quarter, 4), CellState::kOccupied);
  const TrinaryMap tenth = BuildTrinaryMap(grid, 0.1);
  EXPECT_EQ(state(tenth, 0), CellState::kOccupied);
  EXPECT_EQ(state(tenth, 3), CellState::kFree);
  const TrinaryMap half = BuildTrinaryMap(grid, 0.5);
  EXPECT_EQ(state(half, 2), CellState::kFree);
  EXPECT_EQ(state(half, 4), CellState::kOccupied);
}

}  // namespace
}  // namespace gmapping_spa::map
