// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/connected_cells.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

TEST(ConnectedCells, ShareEdgesOrCorners) {
  const auto sets = ConnectedCells(DrawnMap({"#..#",  //
                                             ".#..",  //
                                             "....",  //
                                             "##.."}));
  ASSERT_EQ(sets.size(), 3U);
  EXPECT_EQ(sets[0].size(), 2U);
  EXPECT_EQ(sets[1], (std::vector<std::array<int, 2>>{{1, 2}, {0, 3}}));
  EXPECT_EQ(sets[2], (std::vector<std::array<int, 2>>{{3, 3}}));
}

TEST(ConnectedCells, OfAnEmptyMapAreNone) { EXPECT_TRUE(ConnectedCells(UnknownMap(4, 4)).empty()); }

}  // namespace
}  // namespace gmapping_spa::metrics
