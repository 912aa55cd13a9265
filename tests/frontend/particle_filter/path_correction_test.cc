// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/path_correction.h"

#include <gtest/gtest.h>

#include <vector>

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;

void ExpectSame(const SE2& a, const SE2& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(backend::WrapAngle(a.theta - b.theta), 0.0, 1e-12);
}

const std::vector<SE2> kBefore = {{0, 0, 0}, {1, 0.1, 0.5}, {1.5, 1, 3.0}};
const std::vector<SE2> kAfter = {{0, 0, 0.1}, {1.2, 0.2, 0.4}, {1.4, 1.7, -3.1}};
const SE2 kElsewhere{1.7, -0.4, -2.5};  // a pose of some other path

TEST(PathCorrection, WithoutADifferenceMovesNothing) {
  const PathCorrection none{kBefore, kBefore};
  for (int step = 0; step < 5; ++step) ExpectSame(none.Apply(step, kElsewhere), kElsewhere);
}

TEST(PathCorrection, TakesTheCorrectedPathItselfToWhereItBelongs) {
  const PathCorrection correction{kBefore, kAfter};
  for (int step = 0; step < 3; ++step) {
    ExpectSame(correction.Apply(step, kBefore[step]), kAfter[step]);
  }
}

TEST(PathCorrection, PoseOfAnotherLineageKeepsItsOffsetInTheCorrectedFrame) {
  const PathCorrection correction{kBefore, kAfter};
  for (int step = 0; step < 3; ++step) {
    const SE2 offset{0.3, -0.2, 1.0};
    ExpectSame(correction.Apply(step, kBefore[step] * offset), kAfter[step] * offset);
    ExpectSame(Between(kAfter[step], correction.Apply(step, kElsewhere)),
               Between(kBefore[step], kElsewhere));
  }
}

TEST(PathCorrection, StepBeyondTheLastMovesWithTheLast) {
  const PathCorrection correction{kBefore, kAfter};
  const SE2 with_the_last = correction.Apply(2, kElsewhere);
  for (const int step : {3, 4, 1000000}) {
    EXPECT_TRUE(correction.Apply(step, kElsewhere) == with_the_last) << step;
  }
  EXPECT_FALSE(correction.Apply(1, kElsewhere) == with_the_last);
}

TEST(PathCorrection, OneMotionOfTheWholePathIsThatOfEveryPose) {
  const SE2 moved{3.0, -2.0, 2.5};
  std::vector<SE2> after;
  for (const SE2& pose : kBefore) after.push_back(moved * pose);
  const PathCorrection correction{kBefore, after};
  for (int step = 0; step < 5; ++step) {
    ExpectSame(correction.Apply(step, kElsewhere), moved * kElsewhere);
  }
}

TEST(PathCorrection, OfASinglePoseServesAllSteps) {
  const PathCorrection correction{{{1, 2, 0}}, {{4, 2, 0}}};
  ExpectSame(correction.Apply(0, {1, 2, 0}), {4, 2, 0});
  ExpectSame(correction.Apply(9, {2, 2, 0.5}), {5, 2, 0.5});
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
