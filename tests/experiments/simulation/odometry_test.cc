// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/odometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gmapping_spa::simulation {
namespace {

constexpr double kStepS = 0.05;
constexpr int kRuns = 2000;

struct Moments {
  double sum = 0.0, sum_squares = 0.0;
  void Add(double value) {
    sum += value;
    sum_squares += value * value;
  }
  // Whether mean and variance are those of a normal distribution, within five standard errors.
  void ExpectNormal(double mean, double deviation) const {
    const double variance = deviation * deviation;
    EXPECT_NEAR(sum / kRuns, mean, 5.0 * deviation / std::sqrt(kRuns));
    EXPECT_NEAR(sum_squares / kRuns - mean * mean, variance,
                5.0 * (variance * std::sqrt(2.0 / kRuns) +
                       2.0 * std::abs(mean) * deviation / std::sqrt(kRuns)));
  }
};

backend::SE2 DriveFor(const OdometryOptions& options, std::uint64_t seed,
                      const BodyVelocity& velocity, int steps, double step_s = kStepS) {
  Odometry odometry(options, seed);
  for (int i = 0; i < steps; ++i) odometry.Integrate(velocity, step_s);
  return odometry.odom_T_robot();
}

TEST(Odometry, WithoutNoiseAndInterferenceIsTheTrueMotion) {
  OdometryOptions options;
  options.noise = 0.0;
  options.interference = 0.0;
  const backend::SE2 pose = DriveFor(options, 1, {1.2, 0.4}, 100);
  const backend::SE2 expected = Drive({}, {1.2, 0.4}, 5.0);
  EXPECT_NEAR(pose.x, expected.x, 1e-9);
  EXPECT_NEAR(pose.y, expected.y, 1e-9);
  EXPECT_NEAR(pose.theta, expected.theta, 1e-9);
}

TEST(Odometry, HeadingVarianceGrowsWithDistanceWhateverTheStep) {
  OdometryOptions options;
  options.interference = 0.0;
  // 4 m straight.
  const double expected = options.rotation_rad_per_root_m * 2.0;
  Moments fine, coarse;
  for (int seed = 0; seed < kRuns; ++seed) {
    fine.Add(DriveFor(options, seed, {1.0, 0.0}, 80).theta);
    coarse.Add(DriveFor(options, seed, {1.0, 0.0}, 8, 0.5).theta);
  }
  fine.ExpectNormal(0.0, expected);
  coarse.ExpectNormal(0.0, expected);
}

TEST(Odometry, DistanceVarianceGrowsWithDistance) {
  OdometryOptions options;
  options.interference = 0.0;
  options.rotation_rad_per_root_m = 0.0;
  options.noise = 2.0;
  Moments moments;
  for (int seed = 0; seed < kRuns; ++seed) moments.Add(DriveFor(options, seed, {1.0, 0.0}, 80).x);
  moments.ExpectNormal(4.0, 2.0 * options.translation_m_per_root_m * 2.0);
}

TEST(Odometry, TurningOnTheSpotDisturbsBothHeadingAndPosition) {
  OdometryOptions options;
  options.interference = 0.0;
  Moments heading, forward;
  for (int seed = 0; seed < kRuns; ++seed) {
    Odometry odometry(options, seed);
    odometry.Integrate({0.0, 0.8}, kStepS);
    heading.Add(odometry.measured_velocity().angular_rad_s * kStepS);
    forward.Add(odometry.measured_velocity().linear_m_s * kStepS);
  }
  const double root = std::sqrt(0.8 * kStepS);
  heading.ExpectNormal(0.8 * kStepS, options.rotation_rad_per_root_rad * root);
  forward.ExpectNormal(0.0, options.translation_m_per_root_rad * root);
}

OdometryOptions OnlyInterference() {
  OdometryOptions options;
  options.noise = 0.0;
  options.slips_per_m = options.bumps_per_m = 0.0;
  options.wheel_scale_deviation = options.wheel_ratio_deviation = 0.0;
  return options;
}

TEST(Odometry, SlipsAndBumpsComeAtTheirRates) {
  OdometryOptions options;
  options.slips_per_m = 0.05;
  options.bumps_per_m = 0.02;
  Odometry odometry(options, 3);
  // 5000 m: 250 slips and 100 bumps, Poisson.
  for (int i = 0; i < 100000; ++i) odometry.Integrate({1.0, 0.0}, kStepS);
  EXPECT_NEAR(odometry.slips(), 250, 5.0 * std::sqrt(250.0));
  EXPECT_NEAR(odometry.bumps(), 100, 5.0 * std::sqrt(100.0));
}

TEST(Odometry, ASlipChangesTheSpeedOfOneWheelForAWhile) {
  OdometryOptions options = OnlyInterference();
  options.slips_per_m = 0.02;
  Odometry odometry(options, 3);
  int steps_slipping = 0;
  for (int i = 0; i < 100000; ++i) {
    odometry.Integrate({1.0, 0.0}, kStepS);
    const WheelSpeeds wheels = ToWheelSpeeds(odometry.measured_velocity(), options.wheel_base_m);
    const bool left = std::abs(wheels.left_m_s - 1.0) > 1e-9;
    const bool right = std::abs(wheels.right_m_s - 1.0) > 1e-9;
    steps_slipping += left || right;
  }
  ASSERT_GT(odometry.slips(), 50);
  // 0.4 s are eight steps; a few slips begin before the last one is over.
  EXPECT_NEAR(static_cast<double>(steps_slipping) / odometry.slips(), 8.0, 0.5);
}

TEST(Odometry, ABumpTurnsTheHeadingInOneStep) {
  OdometryOptions options = OnlyInterference();
  options.bumps_per_m = 0.05;
  Odometry odometry(options, 3);
  int steps_turning = 0;
  double sum_squares = 0.0;
  for (int i = 0; i < 100000; ++i) {
    odometry.Integrate({1.0, 0.0}, kStepS);
    const BodyVelocity measured = odometry.measured_velocity();
    EXPECT_EQ(measured.linear_m_s, 1.0);
    steps_turning += measured.angular_rad_s != 0.0;
    sum_squares += std::pow(measured.angular_rad_s * kStepS, 2);
  }
  ASSERT_GT(odometry.bumps(), 100);
  EXPECT_EQ(steps_turning, odometry.bumps());
  const double variance = std::pow(options.bump_deviation_rad, 2);
  EXPECT_NEAR(sum_squares / odometry.bumps(), variance,
              5.0 * variance * std::sqrt(2.0 / odometry.bumps()));
}

TEST(Odometry, WheelsAreWrongByTheSameAllTheWay) {
  OdometryOptions options = OnlyInterference();
  options.wheel_scale_deviation = 0.005;
  options.wheel_ratio_deviation = 0.001;
  Moments scale, ratio;
  for (int seed = 0; seed < kRuns; ++seed) {
    Odometry odometry(options, seed);
    odometry.Integrate({1.0, 0.0}, kStepS);
    const BodyVelocity first = odometry.measured_velocity();
    odometry.Integrate({2.0, 0.0}, kStepS);
    EXPECT_DOUBLE_EQ(odometry.measured_velocity().linear_m_s, 2.0 * first.linear_m_s);
    EXPECT_NEAR(odometry.measured_velocity().angular_rad_s, 2.0 * first.angular_rad_s, 1e-12);
    scale.Add(first.linear_m_s);
    ratio.Add(first.angular_rad_s * options.wheel_base_m / first.linear_m_s);
  }
  scale.ExpectNormal(1.0, 0.005);
  ratio.ExpectNormal(0.0, 0.001);
}

TEST(Odometry, AWheelBaseBelievedTooWideReportsTurnsTooSmall) {
  OdometryOptions options = OnlyInterference();
  options.wheel_base_factor = 1.25;
  Odometry odometry(options, 1);
  odometry.Integrate({1.2, 0.5}, kStepS);
  EXPECT_DOUBLE_EQ(odometry.measured_velocity().angular_rad_s, 0.5 / 1.25);
  EXPECT_DOUBLE_EQ(odometry.measured_velocity().linear_m_s, 1.2);
  odometry.Integrate({0.7, -0.3}, kStepS);
  EXPECT_NEAR(odometry.measured_velocity().angular_rad_s, -0.3 / 1.25, 1e-12);
  options.interference = 0.0;
  EXPECT_NEAR(DriveFor(options, 1, {0.0, 0.5}, 100).theta, 2.5 / 1.25, 1e-9) << "not scaled";
}

TEST(Odometry, InterferenceScalesWhatTheSeedDraws) {
  OdometryOptions options;
  options.noise = 0.0;
  options.slips_per_m = 0.0;
  options.bumps_per_m = 0.05;
  OdometryOptions twice = options;
  twice.interference = 2.0;
  const double heading_rad = DriveFor(options, 5, {1.0, 0.0}, 400).theta;
  ASSERT_GT(std::abs(heading_rad), 1e-3);
  EXPECT_NEAR(DriveFor(twice, 5, {1.0, 0.0}, 400).theta, 2.0 * heading_rad,
              0.02 * std::abs(heading_rad));
}

TEST(Odometry, StandingStillIsNotDisturbed) {
  OdometryOptions options;
  options.slips_per_m = options.bumps_per_m = 1000.0;
  EXPECT_EQ(DriveFor(options, 1, {0.0, 0.0}, 100), backend::SE2());
}

TEST(Odometry, SilentWheelsReportNothing) {
  OdometryOptions options;
  options.silent = true;
  Odometry odometry(options, 1);
  for (int i = 0; i < 200; ++i) odometry.Integrate({1.0, 0.5}, 0.05);
  EXPECT_EQ(odometry.odom_T_robot(), backend::SE2());
  EXPECT_EQ(odometry.measured_velocity().linear_m_s, 0.0);
  EXPECT_EQ(odometry.bumps() + odometry.slips(), 0);
}

TEST(Odometry, AKnockMovesAsWellAsTurns) {
  OdometryOptions options;
  options.noise = options.wheel_scale_deviation = options.wheel_ratio_deviation = 0.0;
  options.slips_per_m = 0.0;
  options.bumps_per_m = 0.5;
  options.bump_deviation_rad = 0.0;
  options.bump_deviation_m = 0.4;
  Odometry odometry(options, 1);
  double sum_squares = 0.0, last_x_m = 0.0;
  for (int i = 0; i < 40000; ++i) {
    odometry.Integrate({1.0, 0.0}, 0.05);
    const double jump_m = odometry.odom_T_robot().x - last_x_m - 0.05;
    last_x_m = odometry.odom_T_robot().x;
    sum_squares += jump_m * jump_m;
  }
  EXPECT_EQ(odometry.odom_T_robot().y, 0.0);
  const double variance = sum_squares / odometry.bumps();
  EXPECT_NEAR(variance, 0.16, 5.0 * 0.16 * std::sqrt(2.0 / odometry.bumps()));
}

TEST(Odometry, NeitherSlipsNorBumpsWhileItIsCalm) {
  OdometryOptions options;
  options.slips_per_m = options.bumps_per_m = 100.0;
  options.calm_s = 10.0;
  Odometry odometry(options, 1);
  for (int i = 0; i < 199; ++i) odometry.Integrate({1.0, 0.0}, 0.05);
  EXPECT_EQ(odometry.slips() + odometry.bumps(), 0);
  for (int i = 0; i < 20; ++i) odometry.Integrate({1.0, 0.0}, 0.05);
  EXPECT_GT(odometry.slips(), 5);
  EXPECT_GT(odometry.bumps(), 5);
}

}  // namespace
}  // namespace gmapping_spa::simulation
