// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/cell_distance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gmapping_spa::metrics {
namespace {

const Square kSquare{{1.0, 2.0}, 0.5};  // from (0.5, 1.5) to (1.5, 2.5)

TEST(CellDistance, OfAPointIsZeroInTheSquareAndOnItsEdge) {
  EXPECT_EQ(Distance(kSquare, Eigen::Vector2d(1.2, 1.6)), 0.0);
  EXPECT_EQ(Distance(kSquare, Eigen::Vector2d(1.5, 2.5)), 0.0);
}

TEST(CellDistance, OfAPointIsToTheNearestSideOrCorner) {
  EXPECT_DOUBLE_EQ(Distance(kSquare, Eigen::Vector2d(3.5, 2.0)), 2.0);
  EXPECT_DOUBLE_EQ(Distance(kSquare, Eigen::Vector2d(-2.5, -2.5)), 5.0);  // 3, 4, 5
}

TEST(CellDistance, OfAnEdgeThatCrossesTheSquareIsZeroWhereverItEnds) {
  EXPECT_EQ(Distance(kSquare, Segment{{-3.0, 2.1}, {4.0, 2.2}}), 0.0);
  EXPECT_EQ(Distance(kSquare, Segment{{1.0, -3.0}, {1.0, 4.0}}), 0.0);
  EXPECT_EQ(Distance(kSquare, Segment{{0.0, 2.0}, {1.0, 3.0}}), 0.0);  // cuts off a corner's tip
}

TEST(CellDistance, OfAnEdgeIsToItsNearestPointWithinItsEnds) {
  EXPECT_DOUBLE_EQ(Distance(kSquare, Segment{{-3.0, 3.5}, {4.0, 3.5}}), 1.0);
  EXPECT_DOUBLE_EQ(Distance(kSquare, Segment{{2.0, 2.0}, {5.0, 2.0}}), 0.5);
  // Passes the corner (1.5, 2.5) at an angle of 45 degrees.
  EXPECT_DOUBLE_EQ(Distance(kSquare, Segment{{1.0, 5.0}, {4.0, 2.0}}), std::sqrt(2.0));
}

}  // namespace
}  // namespace gmapping_spa::metrics
