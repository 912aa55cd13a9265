// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/planar_quaternion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

namespace gmapping_spa::backend {
namespace {

TEST(QuaternionOf, GivesBackTheVeryAngle) {
  constexpr double kPi = std::numbers::pi;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-kPi, kPi);
  std::vector<double> angles = {0.0, 1e-9, -1e-9, kPi / 2.0, -kPi / 2.0, kPi, -kPi};
  for (int k = 0; k < 2000; ++k) angles.push_back(any(random));
  for (const double theta : angles) {
    const auto [qz, qw] = QuaternionOf(theta);
    EXPECT_EQ(YawOf(0.0, 0.0, qz, qw), theta);
    EXPECT_NEAR(qz * qz + qw * qw, 1.0, 1e-12);
  }
}

TEST(YawOf, IsTheRotationAboutZBehindPitchAndRoll) {
  const Eigen::Quaterniond q = Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitX());
  EXPECT_NEAR(YawOf(q.x(), q.y(), q.z(), q.w()), 2.0, 1e-12);
}

}  // namespace
}  // namespace gmapping_spa::backend
