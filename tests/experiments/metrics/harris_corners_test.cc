// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/harris_corners.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;

TEST(HarrisCorners, OfABoxAreItsFour) {
  map::TrinaryMap map = UnknownMap(60, 50);
  Fill(20, 20, 40, 35, CellState::kOccupied, &map);
  const auto corners = FindCorners(map, 0.5);
  ASSERT_EQ(corners.size(), 4U);
  const std::vector<Eigen::Vector2d> box = {{1.0, 1.0}, {2.0, 1.0}, {1.0, 1.75}, {2.0, 1.75}};
  for (std::size_t i = 0; i < box.size(); ++i) EXPECT_LT((corners[i] - box[i]).norm(), 0.11);
}

TEST(HarrisCorners, OfABoxAreAsStrongAsThoseOfAWideWallAndNotStronger) {
  map::TrinaryMap map = UnknownMap(60, 50);
  Fill(20, 20, 40, 35, CellState::kOccupied, &map);
  EXPECT_EQ(FindCorners(map, 0.99).size(), 4U);
  EXPECT_TRUE(FindCorners(map, 1.01).empty());
}

TEST(HarrisCorners, AStraightWallHasNone) {
  map::TrinaryMap map = UnknownMap(60, 50);
  Fill(0, 20, 60, 21, CellState::kOccupied, &map);
  EXPECT_TRUE(FindCorners(map, 0.3).empty());
}

}  // namespace
}  // namespace gmapping_spa::metrics
