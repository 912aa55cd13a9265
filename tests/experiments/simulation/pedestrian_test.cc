// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/pedestrian.h"

#include <gtest/gtest.h>

#include <numbers>

namespace gmapping_spa::simulation {
namespace {

// 2 m to the right, then 1 m up.
const Pedestrian kPedestrian{{0.2, 0.4}, 0.5, {{1.0, 1.0}, {3.0, 1.0}, {3.0, 2.0}}};

void ExpectAt(double time_s, double x, double y, double theta) {
  const Rectangle at = kPedestrian.At(time_s);
  EXPECT_NEAR(at.world_T_center.x, x, 1e-12) << time_s;
  EXPECT_NEAR(at.world_T_center.y, y, 1e-12) << time_s;
  EXPECT_NEAR(at.world_T_center.theta, theta, 1e-12) << time_s;
  EXPECT_EQ(at.half_size_m, Eigen::Vector2d(0.1, 0.2));
}

TEST(Pedestrian, WalksToAndFroFacingAhead) {
  constexpr double kPi = std::numbers::pi;
  ExpectAt(0.0, 1.0, 1.0, 0.0);
  ExpectAt(3.0, 2.5, 1.0, 0.0);
  ExpectAt(5.0, 3.0, 1.5, kPi / 2.0);
  ExpectAt(7.0, 3.0, 1.5, -kPi / 2.0);
  ExpectAt(11.0, 1.5, 1.0, kPi);
  ExpectAt(12.0 + 3.0, 2.5, 1.0, 0.0);
}

}  // namespace
}  // namespace gmapping_spa::simulation
