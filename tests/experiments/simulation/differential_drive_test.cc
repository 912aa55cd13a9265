// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/differential_drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gmapping_spa::simulation::differential_drive_test {
namespace {

constexpr double kWheelBaseM = 0.4;
constexpr double kPi = std::numbers::pi;

TEST(DifferentialDrive, EqualWheelsDriveStraight) {
  const BodyVelocity velocity = ToBodyVelocity({1.5, 1.5}, kWheelBaseM);
  const backend::SE2 pose = Drive({1.0, 2.0, kPi / 6.0}, velocity, 2.0);
  EXPECT_NEAR(pose.x, 1.0 + 3.0 * std::cos(kPi / 6.0), 1e-12);
  EXPECT_NEAR(pose.y, 2.0 + 3.0 * std::sin(kPi / 6.0), 1e-12);
  EXPECT_NEAR(pose.theta, kPi / 6.0, 1e-12);
}

TEST(DifferentialDrive, OppositeWheelsTurnOnTheSpot) {
  const BodyVelocity velocity = ToBodyVelocity({-0.2, 0.2}, kWheelBaseM);
  const backend::SE2 pose = Drive({1.0, 2.0, 0.0}, velocity, 0.5);
  EXPECT_EQ(pose.x, 1.0);
  EXPECT_EQ(pose.y, 2.0);
  EXPECT_NEAR(pose.theta, 0.5, 1e-12);
}

TEST(DifferentialDrive, ConstantWheelsDriveACircleExactlyWhateverTheStep) {
  // v = 1 m/s and omega = 0.5 rad/s: a circle of radius 2 m about (0, 2).
  const BodyVelocity velocity = ToBodyVelocity({0.9, 1.1}, kWheelBaseM);
  EXPECT_NEAR(velocity.linear_m_s, 1.0, 1e-12);
  EXPECT_NEAR(velocity.angular_rad_s, 0.5, 1e-12);
  backend::SE2 pose;
  for (int step = 1; step <= 100; ++step) {
    pose = Drive(pose, velocity, 0.07);
    const double angle = 0.5 * 0.07 * step;
    EXPECT_NEAR(pose.x, 2.0 * std::sin(angle), 1e-12);
    EXPECT_NEAR(pose.y, 2.0 - 2.0 * std::cos(angle), 1e-12);
  }
  const backend::SE2 once = Drive({}, velocity, 7.0);
  EXPECT_NEAR(once.x, pose.x, 1e-12);
  EXPECT_NEAR(once.y, pose.y, 1e-12);
  EXPECT_NEAR(once.theta, pose.theta, 1e-12);
}

TEST(DifferentialDrive, WheelAndBodyVelocitiesAreInverse) {
  const WheelSpeeds wheels = ToWheelSpeeds(ToBodyVelocity({0.3, -0.8}, kWheelBaseM), kWheelBaseM);
  EXPECT_NEAR(wheels.left_m_s, 0.3, 1e-15);
  EXPECT_NEAR(wheels.right_m_s, -0.8, 1e-15);
}

}  // namespace
}  // namespace gmapping_spa::simulation::differential_drive_test
