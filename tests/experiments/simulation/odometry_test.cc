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
  for (int i = 0; i < steps; ++i) odometry.Advance(velocity, step_s);
  return odometry.odom_T_robot();
}

TEST(Odometry, WithoutNoiseAndSlipIsTheTrueMotion) {
  OdometryOptions options;
  options.noise = 0.0;
  options.slip_probability_per_m = 0.0;
  const backend::SE2 pose = DriveFor(options, 1, {1.2, 0.4}, 100);
  const backend::SE2 expected = Drive({}, {1.2, 0.4}, 5.0);
  EXPECT_NEAR(pose.x, expected.x, 1e-9);
  EXPECT_NEAR(pose.y, expected.y, 1e-9);
  EXPECT_NEAR(pose.theta, expected.theta, 1e-9);
}

TEST(Odometry, HeadingVarianceGrowsWithDistanceWhateverTheStep) {
  OdometryOptions options;
  options.slip_probability_per_m = 0.0;
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
  options.slip_probability_per_m = 0.0;
  options.rotation_rad_per_root_m = 0.0;
  options.noise = 2.0;
  Moments moments;
  for (int seed = 0; seed < kRuns; ++seed) moments.Add(DriveFor(options, seed, {1.0, 0.0}, 80).x);
  moments.ExpectNormal(4.0, 2.0 * options.translation_m_per_root_m * 2.0);
}

TEST(Odometry, TurningOnTheSpotDisturbsBothHeadingAndPosition) {
  OdometryOptions options;
  options.slip_probability_per_m = 0.0;
  Moments heading, forward;
  for (int seed = 0; seed < kRuns; ++seed) {
    Odometry odometry(options, seed);
    odometry.Advance({0.0, 0.8}, kStepS);
    heading.Add(odometry.measured_velocity().angular_rad_s * kStepS);
    forward.Add(odometry.measured_velocity().linear_m_s * kStepS);
  }
  const double root = std::sqrt(0.8 * kStepS);
  heading.ExpectNormal(0.8 * kStepS, options.rotation_rad_per_root_rad * root);
  forward.ExpectNormal(0.0, options.translation_m_per_root_rad * root);
}

TEST(Odometry, SlipStartsAtTheGivenRate) {
  OdometryOptions options;
  options.slip_probability_per_m = 0.05;
  Odometry odometry(options, 3);
  // 5000 m: 250 events, Poisson.
  for (int i = 0; i < 100000; ++i) odometry.Advance({1.0, 0.0}, kStepS);
  EXPECT_NEAR(odometry.slip_events(), 250, 5.0 * std::sqrt(250.0));
}

TEST(Odometry, SlipTurnsTheHeadingAndPasses) {
  OdometryOptions options;
  options.noise = 0.0;
  options.slip_probability_per_m = 0.05;
  Odometry odometry(options, 3);
  int steps_turning = 0, jump_steps = 0;
  for (int i = 0; i < 100000; ++i) {
    odometry.Advance({1.0, 0.0}, kStepS);
    const BodyVelocity measured = odometry.measured_velocity();
    if (measured.angular_rad_s == 0.0) continue;
    ++steps_turning;
    jump_steps += measured.linear_m_s == 1.0;
  }
  // Half of the events are jumps of one step, half slip of one wheel for eight steps (0.4 s), which
  // also changes the forward speed.
  const double events = odometry.slip_events();
  EXPECT_NEAR(jump_steps / events, 0.5, 0.16);
  EXPECT_NEAR((steps_turning - jump_steps) / (events - jump_steps), 8.0, 0.5);
}

TEST(Odometry, StandingStillIsNotDisturbed) {
  OdometryOptions options;
  options.slip_probability_per_m = 1000.0;
  EXPECT_EQ(DriveFor(options, 1, {0.0, 0.0}, 100), backend::SE2());
}

}  // namespace
}  // namespace gmapping_spa::simulation
