// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/motion_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

constexpr MotionPrior::Options kOptions{.max_speed_m_s = 2.0, .max_turn_rad_s = 3.0};

MotionPrior Prior(const SE2& wheels, const SE2& same_velocity, double duration_s) {
  return {kOptions, WheelMotion{wheels}, same_velocity, duration_s};
}
MotionPrior PriorWithoutWheels(const SE2& same_velocity, double duration_s) {
  return {kOptions, std::nullopt, same_velocity, duration_s};
}

TEST(MotionPrior, HoldsTheWheelsBeforeGoingOnAsBefore) {
  const SE2 wheels{0.1, 0.01, 0.05}, same{0.12, 0, 0.04};
  const MotionPrior prior = Prior(wheels, same, 0.1);
  ASSERT_EQ(prior.hypotheses().size(), 2u);
  EXPECT_TRUE((prior.hypotheses()[0].motion == wheels));
  EXPECT_TRUE((prior.hypotheses()[1].motion == same));
  EXPECT_NEAR(prior.hypotheses()[0].weight, 0.99, 1e-12);
  EXPECT_NEAR(prior.hypotheses()[1].weight, 0.01, 1e-12);
}

TEST(MotionPrior, AWayThatTheWheelsDoNotTellIsAsUnsureAsGoingOnAsBefore) {
  const SE2 turn{0.12, 0.0, 0.05}, same{0.12, 0.0, 0.0};
  const MotionPrior told = Prior(turn, same, 0.3);
  const MotionPrior untold(kOptions, WheelMotion{.motion = turn, .tells_way = false}, same, 0.3);
  const MotionHypothesis &wheels = untold.hypotheses()[0], &going_on = untold.hypotheses()[1];
  EXPECT_EQ(wheels.sigma_m, going_on.sigma_m);
  EXPECT_GT(wheels.sigma_m, told.hypotheses()[0].sigma_m);
  EXPECT_EQ(wheels.sigma_rad, told.hypotheses()[0].sigma_rad);
}

TEST(MotionPrior, WheelsThatHaveNoSayLeaveGoingOnAsBefore) {
  const SE2 same{0.12, 0, 0.04};
  const MotionPrior prior = PriorWithoutWheels(same, 0.1);
  ASSERT_EQ(prior.hypotheses().size(), 1u);
  EXPECT_TRUE((prior.hypotheses()[0].motion == same));
  EXPECT_EQ(prior.hypotheses()[0].weight, 1.0);
  EXPECT_TRUE(prior.GuessesAgree());
}

TEST(MotionPrior, WheelsAreLessSureOfLongerSteps) {
  const auto wheels = [](const SE2& step) { return Prior(step, {}, 0.1).hypotheses()[0]; };
  EXPECT_DOUBLE_EQ(wheels({}).sigma_m, kOptions.floor_m);
  EXPECT_DOUBLE_EQ(wheels({}).sigma_rad, kOptions.floor_rad);
  EXPECT_DOUBLE_EQ(wheels({0.3, 0.4, 0}).sigma_m, kOptions.floor_m + 0.5 * kOptions.m_per_m);
  EXPECT_DOUBLE_EQ(wheels({0.3, -0.4, -0.2}).sigma_rad,
                   kOptions.floor_rad + 0.5 * kOptions.rad_per_m + 0.2 * kOptions.rad_per_rad);
}

TEST(MotionPrior, WheelsOfBadReputationAreLessSureAndLessLikely) {
  const SE2 step{0.3, 0.4, 0.1};
  const MotionPrior usual = Prior(step, {}, 0.1);
  const MotionPrior bad(kOptions, WheelMotion{step, 3.0, 2.0, 0.25}, {}, 0.1);
  EXPECT_DOUBLE_EQ(bad.hypotheses()[0].sigma_m, 3.0 * usual.hypotheses()[0].sigma_m);
  EXPECT_DOUBLE_EQ(bad.hypotheses()[0].sigma_rad, 2.0 * usual.hypotheses()[0].sigma_rad);
  EXPECT_DOUBLE_EQ(bad.hypotheses()[0].weight, 0.75);
  EXPECT_DOUBLE_EQ(bad.hypotheses()[1].weight, 0.25);
}

TEST(MotionPrior, VelocityChangesWithTheSquareOfTheTime) {
  const auto going_on = [](double duration_s) { return Prior({}, {}, duration_s).hypotheses()[1]; };
  EXPECT_DOUBLE_EQ(going_on(0.1).sigma_m, 0.02 + 0.01);
  EXPECT_DOUBLE_EQ(going_on(0.5).sigma_m, 0.02 + 0.25);
  EXPECT_DOUBLE_EQ(going_on(0.5).sigma_rad, 0.02 + 0.75);
  EXPECT_DOUBLE_EQ(going_on(20.0).sigma_rad, std::numbers::pi);  // nothing is known then
}

TEST(MotionPrior, GuessesAgreeWithinThreeSigmas) {
  const auto agree = [](const SE2& wheels) { return Prior(wheels, {}, 0.1).GuessesAgree(); };
  EXPECT_TRUE(agree({}));
  EXPECT_TRUE(agree({0.08, 0, 0}));
  EXPECT_FALSE(agree({0.1, 0, 0}));
  EXPECT_TRUE(agree({0, 0, 0.14}));
  EXPECT_FALSE(agree({0, 0, -0.16}));
}

TEST(MotionPrior, ReachesAsFarAsARobotGets) {
  const MotionPrior second = Prior({}, {}, 1.0);
  EXPECT_DOUBLE_EQ(second.reach_m(), 2.0);
  EXPECT_DOUBLE_EQ(second.reach_rad(), 3.02);  // what may be expected of the velocity is more
  const MotionPrior long_gap = Prior({}, {}, 60.0);
  EXPECT_DOUBLE_EQ(long_gap.reach_rad(), std::numbers::pi);
}

TEST(MotionPrior, ErrorsOfTheStepsSinceThePoseWasSureAddUp) {
  const SE2 wheels{0.1, 0.01, 0.05}, same{0.12, 0, 0.04};
  const MotionPrior sure = Prior(wheels, same, 0.1);
  const MotionPrior unsure(kOptions, WheelMotion{wheels}, same, 0.1, 4);
  for (const int k : {0, 1}) {
    const MotionHypothesis &now = unsure.hypotheses()[k], &before = sure.hypotheses()[k];
    EXPECT_DOUBLE_EQ(now.sigma_m, 2.0 * before.sigma_m);
    EXPECT_DOUBLE_EQ(now.sigma_rad, 2.0 * before.sigma_rad);
  }
  EXPECT_NEAR(unsure.hypotheses()[0].weight, std::pow(0.99, 4), 1e-12);
  EXPECT_NEAR(unsure.hypotheses()[1].weight, 1.0 - std::pow(0.99, 4), 1e-12);
  EXPECT_DOUBLE_EQ(unsure.reach_m(), 4.0 * sure.reach_m());
  EXPECT_DOUBLE_EQ(unsure.reach_rad(), 4.0 * sure.reach_rad());
}

TEST(MotionPrior, DensityFallsFromTheWheelsToGoingOnToAnything) {
  const SE2 wheels{0.1, 0, 0}, same{-0.1, 0, 0};
  const MotionPrior prior = Prior(wheels, same, 0.1);
  const double at_wheels = prior.LogDensity(wheels), at_same = prior.LogDensity(same);
  const double elsewhere = prior.LogDensity({0, 1.0, 1.0});
  EXPECT_GT(at_wheels, at_same + 2.0);
  EXPECT_GT(at_same, elsewhere + 2.0);
  // Whatever is neither of them is equally likely.
  EXPECT_NEAR(elsewhere, prior.LogDensity({1.0, -1.0, -0.7}), 1e-6);
}

TEST(MotionPrior, DensityIntegratesToTheWeights) {
  const MotionPrior prior = Prior({0.05, 0, 0.1}, {0.1, 0.02, 0}, 0.2);
  constexpr int kSteps = 80;
  const double reach_m = prior.reach_m(), reach_rad = prior.reach_rad();
  const double step_m = 2.0 * reach_m / kSteps, step_rad = 2.0 * reach_rad / (4 * kSteps);
  double sum = 0.0;
  for (int x = 0; x < kSteps; ++x) {
    for (int y = 0; y < kSteps; ++y) {
      for (int a = 0; a < 4 * kSteps; ++a) {
        sum +=
            std::exp(prior.LogDensity({-reach_m + (x + 0.5) * step_m, -reach_m + (y + 0.5) * step_m,
                                       -reach_rad + (a + 0.5) * step_rad}));
      }
    }
  }
  EXPECT_NEAR(sum * step_m * step_m * step_rad, 1.0 + kOptions.anything, 0.002);
}

TEST(MotionHypothesis, DistanceIsThatOfItsInformation) {
  const MotionHypothesis hypothesis{.motion = {0, 0, 0}, .sigma_m = 0.1, .sigma_rad = 0.02};
  const Eigen::Vector3d off(0.05, -0.1, 0.03);
  EXPECT_NEAR(hypothesis.SquaredDistance({off.x(), off.y(), off.z()}),
              off.dot(hypothesis.Information() * off), 1e-9);
}

TEST(MotionHypothesis, DistanceDoesNotDependOnTheFrame) {
  const SE2 off{0.05, -0.1, 0.03};
  const MotionHypothesis still{.motion = {}, .sigma_m = 0.1, .sigma_rad = 0.02};
  const MotionHypothesis turned{.motion = {0.3, 0.1, 2.5}, .sigma_m = 0.1, .sigma_rad = 0.02};
  EXPECT_NEAR(turned.SquaredDistance(turned.motion * off), still.SquaredDistance(off), 1e-9);
}

}  // namespace
}  // namespace gmapping_spa::frontend
