// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/tile_differ.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gmapping_spa::view {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

map::OccupancyGrid EmptyGrid() { return map::OccupancyGrid({}); }

TEST(TileDiffer, FirstMapIsAllNew) {
  map::OccupancyGrid grid = EmptyGrid();
  grid.AddPasses({0, 0}, {5, 0});
  grid.AddHit(-20.5, 3.5);
  TileDiffer differ;
  const TileImages changed = differ.Update(grid);
  ASSERT_THAT(changed, SizeIs(2));
  EXPECT_EQ(changed.at({0, 0})[4], 0);
  EXPECT_EQ(changed.at({0, 0})[5], kUnknownCell);
  EXPECT_EQ(changed.at({-2, 0})[3 * 16 + 11], 100);
  EXPECT_EQ(differ.images(), changed);
}

TEST(TileDiffer, OnlyTilesThatLookOtherwiseAreTold) {
  map::OccupancyGrid grid = EmptyGrid();
  grid.AddHit(3.5, 3.5);
  grid.AddHit(40.5, 3.5);
  TileDiffer differ;
  differ.Update(grid);
  EXPECT_THAT(differ.Update(grid), IsEmpty());
  grid.AddHit(40.5, 3.5);  // another tile now, which looks the same
  EXPECT_THAT(differ.Update(grid), IsEmpty());
  grid.AddPasses({40, 3}, {41, 3});
  const TileImages changed = differ.Update(grid);
  ASSERT_THAT(changed, SizeIs(1));
  EXPECT_EQ(changed.at({2, 0})[3 * 16 + 8], 66);
}

TEST(TileDiffer, ReleasedGridsChangeNothingOfWhatIsTold) {
  map::OccupancyGrid grid = EmptyGrid();
  grid.AddHit(3.5, 3.5);
  TileDiffer differ;
  differ.Update(grid);
  differ.ReleaseGrid();
  EXPECT_EQ(grid.CountOwnTiles(), 1U);
  EXPECT_THAT(differ.Update(grid), IsEmpty());
  EXPECT_EQ(grid.CountOwnTiles(), 0U);
}

TEST(TileDiffer, TilesThatAreGoneBecomeUnknown) {
  map::OccupancyGrid grid = EmptyGrid(), other = EmptyGrid();
  grid.AddHit(3.5, 3.5);
  other.AddHit(100.5, 3.5);
  TileDiffer differ;
  differ.Update(grid);
  const TileImages changed = differ.Update(other);
  ASSERT_THAT(changed, SizeIs(2));
  EXPECT_EQ(changed.at({0, 0}), UnknownImage());
  EXPECT_THAT(differ.images(), SizeIs(1));
  EXPECT_THAT(differ.Update(EmptyGrid()), SizeIs(1));
  EXPECT_THAT(differ.images(), IsEmpty());
}

TEST(TileDiffer, FinishedMapReplacesAGrid) {
  map::OccupancyGrid grid = EmptyGrid();
  grid.AddHit(3.5, 3.5);
  grid.AddHit(100.5, 3.5);
  TileDiffer differ;
  differ.Update(grid);
  map::TrinaryMap map;
  map.width = map.height = 1;
  map.origin_x_m = map.origin_y_m = 3 * map.resolution_m;
  map.cells = {map::CellState::kOccupied};
  const TileImages changed = differ.Update(map);
  EXPECT_THAT(changed, SizeIs(1));  // the other one looks the same
  EXPECT_EQ(changed.begin()->second, UnknownImage());
}

}  // namespace
}  // namespace gmapping_spa::view
