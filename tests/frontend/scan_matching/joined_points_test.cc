// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/joined_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace gmapping_spa::scan_matching {
namespace {

TEST(JoinedPoints, AreInTheFrameOfReferenceAndSoAreTheirDirections) {
  JoinedPoints joined(0.1);
  joined.Add({{.x_m = 2.0, .y_m = 0.0, .back_x = -1.0, .back_y = 0.0}},
             {1.0, 3.0, std::numbers::pi / 2});
  ASSERT_EQ(joined.points().size(), 1u);
  EXPECT_NEAR(joined.points()[0].x_m, 1.0, 1e-12);
  EXPECT_NEAR(joined.points()[0].y_m, 5.0, 1e-12);
  EXPECT_NEAR(joined.points()[0].back_x, 0.0, 1e-12);
  EXPECT_NEAR(joined.points()[0].back_y, -1.0, 1e-12);
}

TEST(JoinedPoints, OfACellTheFirstOneStays) {
  JoinedPoints joined(0.1);
  joined.Add({{.x_m = 0.01, .y_m = 0.01}, {.x_m = -0.01, .y_m = 0.01}}, {});
  joined.Add({{.x_m = 0.09, .y_m = 0.09}, {.x_m = 0.11, .y_m = 0.01}}, {});
  const std::vector<Eigen::Vector2d> positions = PositionsOf(joined.points());
  ASSERT_EQ(positions.size(), 3u);
  EXPECT_EQ(positions[0].x(), 0.01);
  EXPECT_EQ(positions[1].x(), -0.01);
  EXPECT_EQ(positions[2].x(), 0.11);
}

TEST(Thinned, AreNoMoreThanAskedForAndSpreadEvenly) {
  std::vector<Eigen::Vector2d> positions;
  for (int k = 0; k < 1000; ++k) positions.emplace_back(k, 0.0);
  const std::vector<Eigen::Vector2d> thin = Thinned(positions, 100);
  EXPECT_LE(thin.size(), 100u);
  EXPECT_GT(thin.size(), 80u);
  for (std::size_t k = 1; k < thin.size(); ++k) EXPECT_EQ(thin[k].x() - thin[k - 1].x(), 11.0);
  EXPECT_EQ(Thinned(thin, 200), thin);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
