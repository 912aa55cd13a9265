// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/cell_block.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::map::cell_block_test {
namespace {

constexpr double kOccupiedThreshold = 0.3;

using Points = std::vector<std::pair<float, float>>;

// A patch of hits around a corner where tiles meet; `density` of its cells are occupied.
OccupancyGrid RandomGrid(std::uint64_t seed, double density) {
  OccupancyGrid grid({.resolution_m = 0.05, .occupied_threshold = kOccupiedThreshold});
  backend::CounterRandom random(seed, 0);
  for (int y = -12; y < 12; ++y) {
    for (int x = -12; x < 12; ++x) {
      if (random.Uniform() < density) grid.AddHit(x + random.Uniform(), y + random.Uniform());
    }
  }
  for (int i = 0; i < 40; ++i) {  // makes some of them not occupied again
    const CellIndex at{static_cast<int>(24 * random.Uniform()) - 12,
                       static_cast<int>(24 * random.Uniform()) - 12};
    for (int pass = 0; pass < 4; ++pass) grid.AddPasses(at, {at.x + 1, at.y});
  }
  return grid;
}

bool IsOccupied(const OccupancyGrid& grid, CellIndex index) {
  const Cell& cell = grid.cell(index);
  return cell.hits > kOccupiedThreshold * cell.visits;
}

Points BruteForce(const OccupancyGrid& grid, CellIndex index, int dx, int dy) {
  Points points;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const CellIndex at{index.x + x, index.y + y};
      if (!IsOccupied(grid, at) || IsOccupied(grid, {at.x + dx, at.y + dy})) continue;
      const Cell& cell = grid.cell(at);
      points.emplace_back(static_cast<float>(x + cell.mean_x / 65536.0),
                          static_cast<float>(y + cell.mean_y / 65536.0));
    }
  }
  return points;
}

TEST(CellBlock, FindsWhatTheGridHoldsInEveryDirection) {
  int found = 0, blocked = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const OccupancyGrid grid = RandomGrid(seed, 0.1 + 0.04 * static_cast<double>(seed));
    for (const CellIndex center : {CellIndex{0, 0}, {-3, 2}, {5, -6}, {-11, 11}, {2, 12}}) {
      CellBlock block;
      block.CopyFrom(grid, center);
      ASSERT_TRUE(block.Covers(center));
      for (int y = center.y - 4; y <= center.y + 4; ++y) {
        for (int x = center.x - 4; x <= center.x + 4; ++x) {
          if (!block.Covers({x, y})) continue;
          for (int direction = 0; direction < 9; ++direction) {
            const int dx = direction % 3 - 1, dy = direction / 3 - 1;
            if (dx == 0 && dy == 0) continue;
            Points points;
            block.ForEachOccupiedNeighbor({x, y}, dx, dy,
                                          [&](float mx, float my) { points.emplace_back(mx, my); });
            const Points expected = BruteForce(grid, {x, y}, dx, dy);
            ASSERT_THAT(points, testing::UnorderedElementsAreArray(expected))
                << "seed " << seed << " at " << x << " " << y << " toward " << dx << " " << dy;
            found += !points.empty();
            blocked += points.empty() && IsOccupied(grid, {x, y});
          }
        }
      }
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(blocked, 200);
}

// Of the three rows of a neighborhood, four lanes each: whether the first three hold the hit mean
// of their cell where that is occupied, and all others are too far away for any weight but 0.
void ExpectRows(const OccupancyGrid& grid, const CellBlock& block, CellIndex index, int* occupied) {
  constexpr float kNoWeight = 1e4f;  // in cells
  int y = -1;
  block.ForEachRowOfNeighbors(index, [&](const Eigen::Array4f& xs, const Eigen::Array4f& ys) {
    for (int lane = 0; lane < 4; ++lane) {
      const int x = lane - 1;
      const CellIndex at{index.x + x, index.y + y};
      if (lane < 3 && IsOccupied(grid, at)) {
        ASSERT_EQ(xs[lane], static_cast<float>(x + grid.cell(at).mean_x / 65536.0));
        ASSERT_EQ(ys[lane], static_cast<float>(y + grid.cell(at).mean_y / 65536.0));
        ++*occupied;
      } else {
        ASSERT_GT(std::hypot(xs[lane], ys[lane]), kNoWeight) << "lane " << lane << " row " << y;
        ASSERT_TRUE(std::isfinite(xs[lane] * xs[lane] + ys[lane] * ys[lane]));  // 0 times it is 0
      }
    }
    ++y;
  });
  ASSERT_EQ(y, 2);
}

TEST(CellBlock, RowsOfNeighborsHoldTheOccupiedCellsAndNothingElseNearby) {
  int occupied = 0, asked = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const OccupancyGrid grid = RandomGrid(seed, 0.1 + 0.04 * static_cast<double>(seed));
    CellBlock block;  // used again, so that what it held before must not show
    for (const CellIndex center : {CellIndex{0, 0}, {-3, 2}, {5, -6}, {-11, 11}, {2, 12}}) {
      block.CopyFrom(grid, center);
      for (int y = center.y - 4; y <= center.y + 4; ++y) {
        for (int x = center.x - 4; x <= center.x + 4; ++x) {
          if (!block.Covers({x, y})) continue;
          ++asked;
          ExpectRows(grid, block, {x, y}, &occupied);
          if (HasFatalFailure()) FAIL() << "seed " << seed << " at " << x << " " << y;
        }
      }
    }
  }
  EXPECT_EQ(asked, 20 * 5 * 16);
  EXPECT_GT(occupied, 1000);
}

TEST(CellBlock, CoversTheCellsThatHaveTwoMoreToEverySide) {
  CellBlock block;
  block.CopyFrom(OccupancyGrid({}), {100, -200});
  int covered = 0;
  for (int y = -220; y < -180; ++y) {
    for (int x = 80; x < 120; ++x) covered += block.Covers({x, y});
  }
  EXPECT_EQ(covered, 16);  // 4 x 4 of 8 x 8
  EXPECT_TRUE(block.Covers({99, -201}));
  EXPECT_TRUE(block.Covers({101, -199}));
}

TEST(CellBlock, CoversNothingBeforeTheFirstCopy) {
  CellBlock block;
  for (const int x : {-kMaxCellIndex, -1, 0, 1, kMaxCellIndex}) {
    EXPECT_FALSE(block.Covers({x, 0}));
    EXPECT_FALSE(block.Covers({x, x}));
  }
}

TEST(CellBlock, ForgetsTheBlockBefore) {
  OccupancyGrid grid({});
  grid.AddHit(0.5, 0.5);
  CellBlock block;
  block.CopyFrom(grid, {0, 0});
  block.CopyFrom(grid, {50, 50});
  EXPECT_FALSE(block.Covers({0, 0}));
  int found = 0;
  block.ForEachOccupiedNeighbor({50, 50}, 1, 0, [&](float, float) { ++found; });
  EXPECT_EQ(found, 0);
}

}  // namespace
}  // namespace gmapping_spa::map::cell_block_test
