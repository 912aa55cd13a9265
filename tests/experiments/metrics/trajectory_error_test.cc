// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/trajectory_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace gmapping_spa::metrics {
namespace {

using backend::SE2;

constexpr double kDegree = std::numbers::pi / 180.0;

// A truth that visits many places and headings, and an estimate `estimate_T_truth` away from it.
std::vector<PosePair> Moved(const SE2& estimate_T_truth) {
  std::vector<PosePair> pairs;
  for (int k = 0; k < 50; ++k) {
    const SE2 truth = {std::cos(0.1 * k) * k, std::sin(0.3 * k) * 5, backend::WrapAngle(0.4 * k)};
    pairs.push_back({0.1 * k, truth, estimate_T_truth * truth});
  }
  return pairs;
}

// Adds an error in the robot's frame that differs from pose to pose.
std::vector<PosePair> Disturbed(std::vector<PosePair> pairs) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const SE2 error = {0.1 * std::sin(1.7 * k), 0.2 * std::cos(2.3 * k), 0.05 * std::sin(0.9 * k)};
    pairs[k].estimate_T_robot = pairs[k].estimate_T_robot * error;
  }
  return pairs;
}

// Estimate and truth drive straight ahead, a metre and a second a step; the estimate takes
// `estimate_step` instead.
std::vector<PosePair> Drive(int steps, const SE2& estimate_step) {
  std::vector<PosePair> pairs = {{0, {}, {}}};
  for (int k = 1; k <= steps; ++k) {
    pairs.push_back({1.0 * k, pairs.back().truth_T_robot * SE2{1, 0, 0},
                     pairs.back().estimate_T_robot * estimate_step});
  }
  return pairs;
}

TEST(AbsoluteTrajectoryError, OfAShiftIsItsLengthIfNotAligned) {
  const auto error = AbsoluteTrajectoryError(Moved({3, -4, 0}), Alignment::kNone);
  EXPECT_EQ(error.pairs, 50);
  EXPECT_NEAR(error.translation_m.rmse, 5, 1e-12);
  EXPECT_NEAR(error.translation_m.min, 5, 1e-12);
  EXPECT_NEAR(error.translation_m.std, 0, 1e-12);
  EXPECT_NEAR(error.rotation_deg.max, 0, 1e-12);
}

TEST(AbsoluteTrajectoryError, OfARotationAboutTheOriginGrowsWithTheDistanceIfNotAligned) {
  // Chords of 60 degrees are as long as the radius.
  const std::vector<PosePair> pairs = {
      {0, {1, 0, 0}, SE2{0, 0, 60 * kDegree} * SE2{1, 0, 0}},
      {1, {0, 3, 1}, SE2{0, 0, 60 * kDegree} * SE2{0, 3, 1}},
  };
  const auto error = AbsoluteTrajectoryError(pairs, Alignment::kNone);
  EXPECT_NEAR(error.translation_m.min, 1, 1e-12);
  EXPECT_NEAR(error.translation_m.max, 3, 1e-12);
  EXPECT_NEAR(error.translation_m.mean, 2, 1e-12);
  EXPECT_NEAR(error.translation_m.rmse, std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(error.rotation_deg.mean, 60, 1e-9);
  EXPECT_NEAR(error.rotation_deg.std, 0, 1e-9);
}

TEST(AbsoluteTrajectoryError, OneOutlierByHand) {
  // The corners of a square; one of them is 1 m off along the diagonal, which turns nothing, so
  // that the alignment shifts everything by a quarter of it.
  std::vector<PosePair> pairs;
  for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
    const SE2 pose = {1.0 * x, 1.0 * y, 0};
    pairs.push_back({1.0 * pairs.size(), pose, pose});
  }
  pairs[0].estimate_T_robot = {1 + std::sqrt(0.5), 1 + std::sqrt(0.5), 0};
  const auto raw = AbsoluteTrajectoryError(pairs, Alignment::kNone);
  EXPECT_NEAR(raw.translation_m.max, 1, 1e-12);
  EXPECT_NEAR(raw.translation_m.median, 0, 1e-12);
  EXPECT_NEAR(raw.translation_m.rmse, 0.5, 1e-12);
  const auto aligned = AbsoluteTrajectoryError(pairs, Alignment::kSe2);
  EXPECT_NEAR(aligned.translation_m.max, 0.75, 1e-12);
  EXPECT_NEAR(aligned.translation_m.min, 0.25, 1e-12);
  EXPECT_NEAR(aligned.translation_m.mean, 0.375, 1e-12);
  EXPECT_NEAR(aligned.translation_m.rmse, std::sqrt((0.5625 + 3 * 0.0625) / 4), 1e-12);
  EXPECT_NEAR(aligned.rotation_deg.max, 0, 1e-9);
}

TEST(AbsoluteTrajectoryError, AlignmentRemovesAnyRigidMotion) {
  for (const SE2& motion : {SE2{3, -4, 0}, SE2{0, 0, 3.1}, SE2{100, 2000, -1.2}, SE2{0, 0, 0}}) {
    for (const Alignment alignment : {Alignment::kSe2, Alignment::kFirst}) {
      const auto error = AbsoluteTrajectoryError(Moved(motion), alignment);
      EXPECT_NEAR(error.translation_m.max, 0, 1e-9);
      EXPECT_NEAR(error.rotation_deg.max, 0, 1e-9);
      const auto moved = AbsoluteTrajectoryError(Disturbed(Moved(motion)), alignment);
      const auto same_frame = AbsoluteTrajectoryError(Disturbed(Moved({})), alignment);
      EXPECT_GT(same_frame.translation_m.rmse, 0.1);
      EXPECT_NEAR(moved.translation_m.rmse, same_frame.translation_m.rmse, 1e-9);
      EXPECT_NEAR(moved.rotation_deg.rmse, same_frame.rotation_deg.rmse, 1e-9);
    }
  }
}

TEST(Align, FindsTheMotionBetweenTheWorldFrames) {
  const SE2 estimate_T_truth = {2, 1, -2.5};
  for (const Alignment alignment : {Alignment::kSe2, Alignment::kFirst}) {
    const SE2 rest = Align(Moved(estimate_T_truth), alignment) * estimate_T_truth;
    EXPECT_NEAR(rest.translation().norm(), 0, 1e-12);
    EXPECT_NEAR(rest.theta, 0, 1e-12);
  }
  EXPECT_EQ(Align(Moved(estimate_T_truth), Alignment::kNone), SE2{});
}

TEST(Align, NoMotionHasASmallerErrorThanTheLeastSquaresOne) {
  const auto pairs = Disturbed(Moved({1, 2, 3}));
  const double least = AbsoluteTrajectoryError(pairs, Alignment::kSe2).translation_m.rmse;
  const SE2 best = Align(pairs, Alignment::kSe2);
  for (const SE2& step : {SE2{1e-3, 0, 0}, SE2{-1e-3, 0, 0}, SE2{0, 1e-3, 0}, SE2{0, -1e-3, 0},
                          SE2{0, 0, 1e-4}, SE2{0, 0, -1e-4}}) {
    std::vector<PosePair> other = pairs;
    for (PosePair& pair : other) pair.estimate_T_robot = best * step * pair.estimate_T_robot;
    EXPECT_GT(AbsoluteTrajectoryError(other, Alignment::kNone).translation_m.rmse, least);
  }
}

TEST(Align, AStraightLineIsEnough) {
  EXPECT_NEAR(Align(Drive(10, {1, 0, 0}), Alignment::kSe2).theta, 0, 1e-12);
  EXPECT_THROW(Align({}, Alignment::kNone), std::runtime_error);
}

TEST(Align, OfAStandingRobotIsByItsHeading) {
  const SE2 far_away = {1234.5678, -987.1, 0.3};
  for (const Alignment alignment : {Alignment::kSe2, Alignment::kFirst}) {
    const std::vector<PosePair> standing(7, {0, far_away * SE2{0, 0, 0.5}, far_away});
    EXPECT_NEAR(Align(standing, alignment).theta, 0.5, 1e-12);
  }
}

TEST(AbsoluteTrajectoryError, OfAnEstimateThatNeverMovesIsHowFarTheTruthGoes) {
  std::vector<PosePair> pairs = Drive(2, {1, 0, 0});
  for (PosePair& pair : pairs) {
    pair.truth_T_robot = pair.estimate_T_robot;
    pair.estimate_T_robot = {};
  }
  const auto error = AbsoluteTrajectoryError(pairs, Alignment::kSe2);
  EXPECT_NEAR(error.translation_m.min, 0.0, 1e-12);
  EXPECT_NEAR(error.translation_m.max, 1.0, 1e-12);
  EXPECT_NEAR(error.rotation_deg.max, 0.0, 1e-9);
}

TEST(RelativePoseError, OfAKnownDriftPerFrame) {
  const auto pairs = Drive(10, {1.1, 0, 2 * kDegree});
  const auto error = RelativePoseError(pairs, {.step = 1, .unit = StepUnit::kFrames});
  EXPECT_EQ(error.pairs, 10);
  EXPECT_NEAR(error.translation_m.mean, 0.1, 1e-12);
  EXPECT_NEAR(error.translation_m.max, 0.1, 1e-12);
  EXPECT_NEAR(error.rotation_deg.mean, 2, 1e-9);
}

TEST(RelativePoseError, StepsOfSeveralFramesFollowEachOtherWithoutOverlap) {
  const auto error = RelativePoseError(Drive(10, {1.1, 0, 0}), {.step = 3});
  EXPECT_EQ(error.pairs, 3);  // 0-3, 3-6, 6-9
  EXPECT_NEAR(error.translation_m.mean, 0.3, 1e-12);
}

TEST(RelativePoseError, StepsOfMetresAreAlongThePathOfTheEstimateAndDropTheFirst) {
  // Half a metre a frame: 1 m is reached at frames 2, 4, 6, 8, 10.
  const auto error =
      RelativePoseError(Drive(10, {0.5, 0, 0}), {.step = 1, .unit = StepUnit::kMetres});
  EXPECT_EQ(error.pairs, 4);
  EXPECT_NEAR(error.translation_m.mean, 1.0, 1e-12);
}

TEST(RelativePoseError, WhatAStepOfMetresIsTooLongIsNotTakenFromTheNext) {
  // 0.7 m a frame: 1 m is passed at frames 2, 4, 6, 8, 10, each 1.4 m after the one before.
  const auto error =
      RelativePoseError(Drive(10, {0.7, 0, 0}), {.step = 1, .unit = StepUnit::kMetres});
  EXPECT_EQ(error.pairs, 4);
  EXPECT_NEAR(error.translation_m.max, 0.6, 1e-12);
}

TEST(RelativePoseError, StepsOfSecondsTolerateRoundedStamps) {
  auto pairs = Drive(20, {1.1, 0, 0});
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k].stamp_s = 976052857.3 + 0.1 * k;
  const auto second = RelativePoseError(pairs, {.step = 1, .unit = StepUnit::kSeconds});
  EXPECT_EQ(second.pairs, 2);
  EXPECT_NEAR(second.translation_m.max, 1.0, 1e-12);
  // Near 1e9 s a double steps by 1e-7 s, so that some of these differences are less than 0.1 s.
  const auto tenth = RelativePoseError(pairs, {.step = 0.1, .unit = StepUnit::kSeconds});
  EXPECT_EQ(tenth.pairs, 20);
}

TEST(RelativePoseError, DoesNotDependOnTheWorldFrame) {
  for (const StepUnit unit : {StepUnit::kFrames, StepUnit::kMetres, StepUnit::kSeconds}) {
    const auto a = RelativePoseError(Disturbed(Moved({})), {.step = 2, .unit = unit});
    const auto b = RelativePoseError(Disturbed(Moved({7, 8, 2})), {.step = 2, .unit = unit});
    EXPECT_GT(a.translation_m.mean, 0.01);
    EXPECT_NEAR(a.translation_m.mean, b.translation_m.mean, 1e-9);
    EXPECT_NEAR(a.rotation_deg.mean, b.rotation_deg.mean, 1e-9);
  }
}

TEST(RelativePoseError, RejectsStepsThatDoNotFit) {
  const auto pairs = Drive(5, {1, 0, 0});
  EXPECT_THROW(RelativePoseError(pairs, {.step = 0}), std::invalid_argument);
  EXPECT_THROW(RelativePoseError(pairs, {.step = 1.5}), std::invalid_argument);
  EXPECT_THROW(RelativePoseError(pairs, {.step = NAN, .unit = StepUnit::kMetres}),
               std::invalid_argument);
  EXPECT_THROW(RelativePoseError(pairs, {.step = 6}), std::runtime_error);
  EXPECT_THROW(RelativePoseError(pairs, {.step = 100, .unit = StepUnit::kMetres}),
               std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::metrics
