// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gmapping_spa::simulation::shapes_test {
namespace {

constexpr double kPi = std::numbers::pi;

// 2 m x 1 m about (3, 4), turned by 30 degrees.
const Rectangle kTurned{{3.0, 4.0, kPi / 6.0}, {1.0, 0.5}};

TEST(Rectangle, ContainsWhatLiesBetweenItsSides) {
  const Rectangle box = Rectangle::FromCorners({1.0, 2.0}, {4.0, 2.5});
  EXPECT_TRUE(box.Contains({1.01, 2.01}));
  EXPECT_TRUE(box.Contains({3.99, 2.49}));
  EXPECT_FALSE(box.Contains({0.99, 2.2}));
  EXPECT_FALSE(box.Contains({2.0, 2.51}));
  EXPECT_TRUE(kTurned.Contains(kTurned.world_T_center * Eigen::Vector2d(0.99, -0.49)));
  EXPECT_FALSE(kTurned.Contains(kTurned.world_T_center * Eigen::Vector2d(0.99, -0.51)));
}

TEST(Rectangle, ExtentIsThatOfItsCorners) {
  const double corner_x = std::cos(kPi / 6.0) * 1.0 + std::sin(kPi / 6.0) * 0.5;
  const double corner_y = std::sin(kPi / 6.0) * 1.0 + std::cos(kPi / 6.0) * 0.5;
  EXPECT_NEAR(kTurned.HalfExtent().x(), corner_x, 1e-12);
  EXPECT_NEAR(kTurned.HalfExtent().y(), corner_y, 1e-12);
}

TEST(Rectangle, NearestPointIsOnASideACornerOrThePointItself) {
  const auto nearest = [](double x, double y) -> Eigen::Vector2d {
    return Inverse(kTurned.world_T_center) *
           kTurned.Nearest(kTurned.world_T_center * Eigen::Vector2d(x, y));
  };
  EXPECT_TRUE(nearest(0.3, 2.0).isApprox(Eigen::Vector2d(0.3, 0.5), 1e-9));
  EXPECT_TRUE(nearest(-2.0, -3.0).isApprox(Eigen::Vector2d(-1.0, -0.5), 1e-9));
  EXPECT_TRUE(nearest(0.2, 0.1).isApprox(Eigen::Vector2d(0.2, 0.1), 1e-9));
}

TEST(Rectangle, RaysEndWhereTheyEnter) {
  const Eigen::Vector2d origin(-1.0, -2.0);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const double angle_rad = 0.5 + i * 0.001;
    const std::optional<double> range_m = kTurned.CastRay(origin, angle_rad);
    if (!range_m) continue;
    ++hits;
    const Eigen::Vector2d along(std::cos(angle_rad), std::sin(angle_rad));
    EXPECT_FALSE(kTurned.Contains(origin + (*range_m - 1e-6) * along));
    const Eigen::Vector2d end =
        Inverse(kTurned.world_T_center) * Eigen::Vector2d(origin + *range_m * along);
    EXPECT_NEAR(std::max(std::abs(end.x()) / 1.0, std::abs(end.y()) / 0.5), 1.0, 1e-9);
  }
  EXPECT_GT(hits, 200);
}

TEST(Rectangle, RaysAlongItsSidesAndFromInside) {
  const Rectangle box = Rectangle::FromCorners({1.0, 2.0}, {4.0, 2.5});
  EXPECT_NEAR(box.CastRay({0.0, 2.25}, 0.0).value(), 1.0, 1e-12);
  EXPECT_FALSE(box.CastRay({0.0, 1.9}, 0.0).has_value());
  EXPECT_FALSE(box.CastRay({0.0, 2.25}, kPi).has_value());
  EXPECT_EQ(box.CastRay({2.0, 2.25}, 1.0), 0.0);
}

TEST(Disc, ContainsWhatIsNoFartherThanItsRadius) {
  const Disc disc{{1.0, 2.0}, 0.5};
  EXPECT_TRUE(disc.Contains({1.3, 2.39}));
  EXPECT_FALSE(disc.Contains({1.3, 2.41}));
}

}  // namespace
}  // namespace gmapping_spa::simulation::shapes_test
