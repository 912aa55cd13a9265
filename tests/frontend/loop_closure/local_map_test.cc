// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/local_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "frontend/map/scan_insertion.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

class LocalMap : public testing::Test {
 protected:
  sensor::LaserScan ScanOf(int node) const { return synthetic::Scan(walls_, poses_[node]); }
  ScanOfNode scan_of_node_ = [this](int node) { return ScanOf(node); };

  const synthetic::Walls walls_ = synthetic::Room();
  const std::vector<SE2> poses_ = {
      {-1, -1, 0.2}, {0, -1, 0.5}, {1, -0.5, 1.2}, {1.2, 0.5, 1.8}, {0.3, 1, 2.9}};
};

TEST(NodesAround, GoesSoFarOnThePathToEitherSide) {
  std::vector<SE2> poses;
  for (int k = 0; k < 20; ++k) poses.push_back({1.0 * k, 0, 0});
  const auto expect = [&](int center, double reach_m, int first, int last) {
    const NodeRange range = NodesAround(poses, center, reach_m);
    EXPECT_EQ(range.first, first) << center << ' ' << reach_m;
    EXPECT_EQ(range.last, last) << center << ' ' << reach_m;
  };
  expect(10, 3.5, 7, 13);
  expect(10, 3.0, 7, 13);
  expect(10, 0.0, 10, 10);
  expect(1, 3.5, 0, 4);
  expect(19, 3.5, 16, 19);
  expect(10, 100.0, 0, 19);
}

TEST(NodesAround, CountsTheWayAndNotTheDistance) {
  // To and fro: after the turn the path comes near the center again.
  std::vector<SE2> poses;
  for (const double x : {0, 1, 2, 3, 2, 1, 0}) poses.push_back({x, 0, 0});
  const NodeRange range = NodesAround(poses, 0, 4.0);
  EXPECT_EQ(range.first, 0);
  EXPECT_EQ(range.last, 4);
}

TEST_F(LocalMap, IsThatOfTheScansRegisteredInTheFrameOfTheReference) {
  const NodeRange nodes{1, 3};
  const int reference = 2;
  const map::OccupancyGrid map = BuildLocalMap(poses_, scan_of_node_, nodes, reference, {});
  map::OccupancyGrid expected({});
  for (int node = nodes.first; node <= nodes.last; ++node) {
    map::InsertScan(ScanOf(node), Inverse(poses_[reference]) * poses_[node], {}, &expected);
  }
  int known = 0;
  for (int x = -250; x < 250; ++x) {
    for (int y = -250; y < 250; ++y) {
      const map::Cell& cell = map.cell({x, y});
      ASSERT_EQ(cell.visits, expected.cell({x, y}).visits) << x << ' ' << y;
      ASSERT_EQ(cell.hits, expected.cell({x, y}).hits) << x << ' ' << y;
      known += cell.visits > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(known, 10000);
}

TEST_F(LocalMap, JoinedScansHaveOnePointACellInTheFrameOfTheReference) {
  constexpr double kCellM = 0.2;
  const int reference = 3;
  const scan_matching::ScanPoints joined =
      JoinScans(poses_, scan_of_node_, {0, 4}, reference, kCellM);
  std::set<std::pair<int, int>> cells;
  for (const scan_matching::ScanPoint& point : joined) {
    const std::pair cell(static_cast<int>(std::floor(point.x_m / kCellM)),
                         static_cast<int>(std::floor(point.y_m / kCellM)));
    EXPECT_TRUE(cells.insert(cell).second) << point.x_m << ' ' << point.y_m;
  }
  // Every end point of every scan is represented by one in its cell, and nothing else is there.
  std::set<std::pair<int, int>> expected;
  for (int node = 0; node <= 4; ++node) {
    for (const scan_matching::ScanPoint& point : scan_matching::MakeScanPoints(ScanOf(node))) {
      const Eigen::Vector2d at =
          Between(poses_[reference], poses_[node]) * Eigen::Vector2d(point.x_m, point.y_m);
      expected.emplace(static_cast<int>(std::floor(at.x() / kCellM)),
                       static_cast<int>(std::floor(at.y() / kCellM)));
    }
  }
  EXPECT_EQ(cells, expected);
}

TEST_F(LocalMap, JoinedScansLookBackToTheirLasers) {
  // A scan with a single node: all points look back to the laser's place in the reference frame.
  const int reference = 0, node = 3;
  const Eigen::Vector2d laser = Between(poses_[reference], poses_[node]).translation();
  const scan_matching::ScanPoints joined =
      JoinScans(poses_, scan_of_node_, {node, node}, reference, 0.1);
  ASSERT_GT(joined.size(), 50u);
  for (const scan_matching::ScanPoint& point : joined) {
    const Eigen::Vector2d at(point.x_m, point.y_m);
    const Eigen::Vector2d back(point.back_x, point.back_y);
    EXPECT_LT(((laser - at).normalized() - back).norm(), 1e-9);
  }
}

TEST_F(LocalMap, BlindScansJoinToNothing) {
  const ScanOfNode blind = [](int) { return sensor::LaserScan{}; };
  EXPECT_TRUE(JoinScans(poses_, blind, {0, 4}, 0, 0.1).empty());
  EXPECT_EQ(BuildLocalMap(poses_, blind, {0, 4}, 0, {}).CountTiles(), 0u);
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
