// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/local_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "backend/counter_random.h"

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

TEST(LocalSurface, IsTheGaussianOfTheHitMeansThatTheWindowWeighs) {
  backend::CounterRandom random(3, 0);
  for (int trial = 0; trial < 200; ++trial) {
    // One hit a cell, in a third of them, so that its mean is known; beyond the neighborhood, too.
    map::OccupancyGrid grid({});
    std::vector<Eigen::Vector2d> neighbors;
    const int corner = trial % 2 == 0 ? 0 : 31;  // in the middle of a tile and at the edge of one
    for (int y = -4; y <= 4; ++y) {
      for (int x = -4; x <= 4; ++x) {
        if (random.Uniform() > 0.33) continue;
        const Eigen::Vector2d hit(corner + x + random.Uniform(), corner + y + random.Uniform());
        grid.AddHit(hit.x(), hit.y());
        if (std::abs(x) <= 1 && std::abs(y) <= 1) neighbors.push_back(hit);
      }
    }
    if (neighbors.empty()) continue;
    const Eigen::Vector2d point(corner + random.Uniform(), corner + random.Uniform());
    double sum = 0.0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector2d& hit : neighbors) {
      const Eigen::Vector2d d = hit - point;
      const double weight = std::pow(std::max(0.0, 1.0 - d.squaredNorm() / 4.0), 2);
      sum += weight;
      mean += weight * d;
      second += weight * d * d.transpose();
    }
    if (sum < 1e-3) continue;  // all but out of the window: what is left is rounding
    mean /= sum;
    const Eigen::Matrix2d covariance = second / sum - mean * mean.transpose();
    const LocalSurface surface = Fitted(grid, point.x(), point.y());
    ASSERT_LT((surface.offset.cast<double>() - mean).norm(), 1e-4) << trial;
    ASSERT_LT((surface.covariance.cast<double>() - covariance).norm(), 1e-4) << trial;
  }
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
