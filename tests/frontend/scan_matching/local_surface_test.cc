#include "frontend/scan_matching/local_surface.h"

#include <gtest/gtest.h>

namespace gmapping_spa::scan_matching {
namespace {

using map::CellIndex;

// A wall along x, hit in the middle of each cell of row 0.
map::OccupancyGrid WallAlongX() {
  map::OccupancyGrid grid({});
  for (int x = -20; x < 20; ++x) grid.AddHit(x + 0.5, 0.5);
  return grid;
}

LocalSurface Fitted(const map::OccupancyGrid& grid, double x, double y) {
  const CellIndex index{map::FloorToCell(x), map::FloorToCell(y)};
  map::CellBlock block;
  block.CopyFrom(grid, index);
  LocalSurface surface;
  EXPECT_TRUE(surface.Fit(block, index, x, y));
  return surface;
}

TEST(LocalSurface, MeasuresTheDistanceAcrossAWall) {
  for (const double y : {0.1, 0.5, 0.9, 1.3}) {
    const LocalSurface surface = Fitted(WallAlongX(), 5.3, y);
    EXPECT_NEAR(surface.offset.y(), 0.5 - y, 1e-4);
    EXPECT_NEAR(surface.covariance(1, 1), 0.0, 1e-4);
    EXPECT_NEAR(surface.Information(0.5f)(1, 1), 4.0, 1e-2);
  }
}

TEST(LocalSurface, HardlyChangesAlongAWall) {
  const map::OccupancyGrid wall = WallAlongX();
  for (double x = 3.0; x < 6.0; x += 0.05) {
    const LocalSurface surface = Fitted(wall, x, 0.7);
    const double squared = surface.offset.dot(surface.Information(0.5f) * surface.offset);
    EXPECT_NEAR(squared, 0.2 * 0.2 * 4.0, 0.04) << x;  // the nearest hit mean would add up to 1
  }
}

TEST(LocalSurface, OfALonelyHitIsThatPoint) {
  map::OccupancyGrid grid({});
  grid.AddHit(2.25, -3.5);
  const LocalSurface surface = Fitted(grid, 2.75, -3.25);
  EXPECT_NEAR(surface.offset.x(), -0.5, 1e-4);
  EXPECT_NEAR(surface.offset.y(), -0.25, 1e-4);
  EXPECT_NEAR(surface.covariance.norm(), 0.0, 1e-4);
}

TEST(LocalSurface, NeedsAHitNearby) {
  map::OccupancyGrid grid({});
  grid.AddHit(2.5, 2.5);
  map::CellBlock block;
  block.CopyFrom(grid, {0, 0});
  LocalSurface surface;
  EXPECT_FALSE(surface.Fit(block, {0, 0}, 0.5, 0.5));
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
