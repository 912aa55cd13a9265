// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/ring_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "experiments/metrics/cell_distance.h"
#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

constexpr double kCap_m = 0.8;

double DistanceToOccupied(const map::TrinaryMap& map, const Eigen::Vector2d& point, int column,
                          int row) {
  if (map.at(column, row) != map::CellState::kOccupied) return kCap_m;
  return Distance(Square{CellCenter(map, column, row), 0.5 * map.resolution_m}, point);
}

TEST(RingSearch, FindsWhatTryingAllCellsFinds) {
  map::TrinaryMap map = UnknownMap(37, 23);
  for (const auto& [column, row] : {std::pair(3, 4), std::pair(30, 20), std::pair(31, 2)}) {
    map.at(column, row) = map::CellState::kOccupied;
  }
  for (double x = -0.613; x < 2.5; x += 0.117) {
    for (double y = -0.613; y < 2.0; y += 0.117) {
      const Eigen::Vector2d point(x, y);
      const auto distance = [&](int column, int row) {
        return DistanceToOccupied(map, point, column, row);
      };
      double nearest = kCap_m;
      for (int row = 0; row < map.height; ++row) {
        for (int column = 0; column < map.width; ++column) {
          nearest = std::min(nearest, distance(column, row));
        }
      }
      EXPECT_EQ(SearchRings(map, point, kCap_m, 0.0, distance), nearest) << x << ", " << y;
    }
  }
}

TEST(RingSearch, GivesTheCapWhenNothingIsNearer) {
  const map::TrinaryMap map = UnknownMap(10, 10);
  const Eigen::Vector2d point(0.2, 0.2);
  EXPECT_EQ(
      SearchRings(map, point, kCap_m, 0.0,
                  [&](int column, int row) { return DistanceToOccupied(map, point, column, row); }),
      kCap_m);
}

}  // namespace
}  // namespace gmapping_spa::metrics
