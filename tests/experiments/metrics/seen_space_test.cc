// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/seen_space.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

constexpr int kRight = 0, kUp = 1, kLeft = 2, kDown = 3;  // of kSides

// The center of a cell.
backend::StampedPose PoseIn(int column, int row) {
  return {0.0, {0.05 * (column + 0.5), 0.05 * (row + 0.5), 0.0}};
}

TEST(SeenSpace, EndsAtWalls) {
  const auto seen = LookAround(DrawnMap({"#######",  //
                                         "#..#..#",  //
                                         "#######"}),
                               {PoseIn(1, 1)}, 30.0);
  EXPECT_TRUE(seen.IsSeen(1, 1));
  EXPECT_TRUE(seen.IsSeen(2, 1));
  EXPECT_FALSE(seen.IsSeen(3, 1)) << "a wall is not free space";
  EXPECT_FALSE(seen.IsSeen(4, 1)) << "behind the wall";
  EXPECT_FALSE(seen.IsSeen(-1, 1)) << "outside of the map";
  EXPECT_TRUE(seen.IsSideSeen(3, 1, kLeft));
  EXPECT_FALSE(seen.IsSideSeen(3, 1, kRight));
  EXPECT_TRUE(seen.IsSideSeen(1, 0, kUp));
  EXPECT_TRUE(seen.IsSideSeen(1, 2, kDown));
  EXPECT_FALSE(seen.IsSideSeen(4, 2, kDown)) << "a wall of the other room";
}

TEST(SeenSpace, LeavesTheShadowOfThings) {
  const auto seen = LookAround(DrawnMap({".......",  //
                                         ".......",  //
                                         "...#...",  //
                                         ".......",  //
                                         "......."}),
                               {PoseIn(1, 2)}, 30.0);
  EXPECT_FALSE(seen.IsSeen(4, 2));
  EXPECT_FALSE(seen.IsSeen(6, 2));
  EXPECT_TRUE(seen.IsSeen(4, 4));
  EXPECT_FALSE(seen.IsSideSeen(3, 2, kUp)) << "seen along its face only";
}

TEST(SeenSpace, EndsAtTheRangeAndAtUnknownCells) {
  const map::TrinaryMap row = DrawnMap({"..........   .."});
  const auto near = LookAround(row, {PoseIn(0, 0)}, 0.2);
  EXPECT_TRUE(near.IsSeen(4, 0));
  EXPECT_FALSE(near.IsSeen(5, 0));
  const auto far = LookAround(row, {PoseIn(0, 0)}, 30.0);
  EXPECT_TRUE(far.IsSeen(9, 0));
  EXPECT_FALSE(far.IsSeen(13, 0));
}

TEST(SeenSpace, LooksFromPosesAQuarterOfAMetreApartInFreeSpace) {
  const map::TrinaryMap row = DrawnMap({".................#.."});
  // 0, 0.1, 0.2, 0.25, 0.4, 0.5 m along the way; in the wall; outside.
  const auto seen = LookAround(row,
                               {PoseIn(0, 0), PoseIn(2, 0), PoseIn(4, 0), PoseIn(5, 0),
                                PoseIn(8, 0), PoseIn(10, 0), PoseIn(17, 0), PoseIn(90, 0)},
                               30.0);
  EXPECT_EQ(seen.view_points, 3);
}

TEST(SeenSpace, NeedsAPoseInFreeSpace) {
  EXPECT_THROW(LookAround(DrawnMap({"..#"}), {PoseIn(2, 0), PoseIn(3, 0)}, 30.0),
               std::runtime_error);
  EXPECT_THROW(LookAround(DrawnMap({"..#"}), {}, 30.0), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::metrics
