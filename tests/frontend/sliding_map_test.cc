// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sliding_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "frontend/map/scan_insertion.h"
#include "frontend/scan_matching/scan_points.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::frontend::sliding_map_test {
namespace {

using backend::SE2;

// The k-th of a row of places from which the room is seen.
SE2 Place(int k) { return {-1.0 + 0.05 * k, 0.3 * std::sin(k), 0.7 * k}; }

sensor::LaserScan ScanAt(const SE2& pose) { return synthetic::Scan(synthetic::Room(), pose); }

std::vector<Eigen::Vector2d> Positions(const SE2& pose) {
  std::vector<Eigen::Vector2d> positions;
  for (const auto& point : scan_matching::MakeScanPoints(ScanAt(pose))) {
    positions.emplace_back(point.x_m, point.y_m);
  }
  return positions;
}

bool Same(const map::OccupancyGrid& a, const map::OccupancyGrid& b) {
  for (int x = -150; x < 150; ++x) {
    for (int y = -150; y < 150; ++y) {
      const map::Cell &in_a = a.cell({x, y}), &in_b = b.cell({x, y});
      if (in_a.visits != in_b.visits || in_a.hits != in_b.hits) return false;
    }
  }
  return true;
}

map::OccupancyGrid MapOf(int first, int last) {
  map::OccupancyGrid grid({});
  for (int k = first; k <= last; ++k) {
    map::InsertScan(ScanAt(Place(k)), Place(k), {.clear_margin_m = 0.2}, &grid);
  }
  return grid;
}

TEST(SlidingMap, IsEmptyUntilAScanIsEntered) {
  SlidingMap map({}, 4);
  EXPECT_TRUE(map.empty());
  map.Insert(ScanAt({}), {});
  EXPECT_FALSE(map.empty());
}

TEST(SlidingMap, HoldsTheLastScansBetweenHalfOfThemAndAll) {
  constexpr int kScans = 6;
  SlidingMap map({}, kScans);
  for (int k = 0; k < 25; ++k) {
    map.Insert(ScanAt(Place(k)), Place(k));
    int held = 0;
    for (int scans = 1; scans <= k + 1 && held == 0; ++scans) {
      if (Same(map.grid(), MapOf(k + 1 - scans, k))) held = scans;
    }
    EXPECT_GE(held, std::min(k + 1, kScans / 2)) << k;
    EXPECT_LE(held, kScans) << k;
  }
}

TEST(SlidingMap, HoldsMoreScansOfFewBeams) {
  SlidingMap map({}, 2);
  for (int k = 0; k < 8; ++k) {
    sensor::LaserScan scan = ScanAt(Place(k));
    scan.beams.resize(18);  // worth a twenty-fifth
    map.Insert(scan, Place(k));
  }
  const map::CellIndex laser{map::FloorToCell(Place(0).x / 0.05),
                             map::FloorToCell(Place(0).y / 0.05)};
  EXPECT_GT(map.grid().cell(laser).visits, 0);  // the first scan is still there
}

TEST(SlidingMap, ForgetsEverythingWhenCleared) {
  SlidingMap map({}, 4);
  for (int k = 0; k < 5; ++k) map.Insert(ScanAt(Place(k)), Place(k));
  map.Clear();
  EXPECT_TRUE(map.empty());
  map.Insert(ScanAt(Place(7)), Place(7));
  EXPECT_TRUE(Same(map.grid(), MapOf(7, 7)));
}

TEST(SlidingMap, SearchFindsAScanInItsSurroundings) {
  SlidingMap map({}, 8);
  for (int k = 0; k < 6; ++k) map.Insert(ScanAt(Place(k)), Place(k));
  const SE2 truth = Place(4) * SE2{0.4, -0.3, 0.5};
  const auto found = map.Search({}, Place(5), 10.0).Match(Positions(truth), Place(4), {0.75, 0.8});
  ASSERT_TRUE(found.found);
  const SE2 off = Between(truth, found.map_T_scan);
  EXPECT_LT(off.translation().norm(), 0.06);
  EXPECT_LT(std::abs(off.theta), 0.03);
}

TEST(SlidingMap, SearchKnowsWhatWasEnteredSince) {
  SlidingMap map({}, 8);
  const SE2 elsewhere{30, 0, 0};
  map.Insert(ScanAt({}), {});
  ASSERT_TRUE(map.Search({}, {}, 10.0).Match(Positions({}), {}, {0.2, 0.1}).found);
  // The same room once more, far away.
  map.Insert(ScanAt({}), elsewhere);
  EXPECT_TRUE(map.Search({}, elsewhere, 10.0).Match(Positions({}), elsewhere, {0.2, 0.1}).found);
}

TEST(SlidingMap, SearchFollowsTheRobot) {
  SlidingMap map({}, 8);
  const SE2 elsewhere{30, 0, 0};
  map.Insert(ScanAt({}), {});
  map.Insert(ScanAt({}), elsewhere);
  for (const SE2& there : {SE2{}, elsewhere, SE2{}}) {
    EXPECT_TRUE(map.Search({}, there, 10.0).Match(Positions({}), there, {0.2, 0.1}).found);
    const SE2 away = there.x == 0.0 ? elsewhere : SE2{};
    EXPECT_FALSE(map.Search({}, there, 10.0).Match(Positions({}), away, {0.2, 0.1}).found);
  }
}

}  // namespace
}  // namespace gmapping_spa::frontend::sliding_map_test
