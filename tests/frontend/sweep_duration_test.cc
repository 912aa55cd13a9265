// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sweep_duration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "backend/counter_random.h"
#include "tests/frontend/moving_laser.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// A robot in a room that stands still, turns on the spot, and stands again, its poses well known.
class TurningOnTheSpot : public testing::Test {
 protected:
  void Turn(double sweep_s, double turn_rad_s, int scans) {
    for (int k = 0; k < scans; ++k) {
      // Stands for two scans; then up to speed and down again, within two scans each.
      const double part = std::clamp(0.5 * std::min(k - 1, scans - 1 - k), 0.0, 1.0);
      Go(synthetic::Room(), sweep_s, {0.0, 0.0, part * turn_rad_s});
    }
  }

  void Go(const synthetic::Walls& walls, double sweep_s, const Eigen::Vector3d& velocity) {
    pose_ = pose_ * backend::Exp(interval_s_ * velocity);
    sensor::LaserScan scan = synthetic::ScanOnTheMove(walls, pose_, sweep_s * velocity);
    for (sensor::Beam& beam : scan.beams) beam.range_m += 0.01 * random_.Gaussian();
    scan.stamp_s = stamp_s_ += interval_s_;
    sweep_.Learn(scan, pose_, velocity);
  }

  SweepDuration sweep_{{}, {}, std::nullopt};
  SE2 pose_;
  double stamp_s_ = 5.0;
  double interval_s_ = 0.15;
  backend::CounterRandom random_{1, 0};
};

TEST_F(TurningOnTheSpot, IsLearnedInOneTurn) {
  Turn(0.1, 1.2, 12);
  EXPECT_NEAR(sweep_.value_s(), 0.1, 0.01);
}

TEST_F(TurningOnTheSpot, IsNegativeWhereBeamsAreListedInTheOppositeOrder) {
  Turn(-0.1, 1.2, 12);
  EXPECT_NEAR(sweep_.value_s(), -0.1, 0.01);
}

TEST_F(TurningOnTheSpot, OfALaserThatMeasuresAllAtOnceIsZero) {
  for (int turn = 0; turn < 5; ++turn) Turn(0.0, turn % 2 == 0 ? 1.2 : -0.8, 12);
  EXPECT_EQ(sweep_.value_s(), 0.0);
}

TEST_F(TurningOnTheSpot, OfALaserThatTurnsFastIsZero) {
  for (int turn = 0; turn < 5; ++turn) Turn(0.0066, turn % 2 == 0 ? 1.2 : -0.8, 12);
  EXPECT_EQ(sweep_.value_s(), 0.0);
}

TEST_F(TurningOnTheSpot, IsNotLearnedFromARobotThatHardlyTurns) {
  for (int turn = 0; turn < 5; ++turn) Turn(0.1, 0.2, 12);
  EXPECT_EQ(sweep_.value_s(), 0.0);
}

TEST_F(TurningOnTheSpot, GrowsMoreAccurateWithTurns) {
  for (int turn = 0; turn < 6; ++turn) Turn(0.1, turn % 2 == 0 ? 1.2 : -1.2, 12);
  EXPECT_NEAR(sweep_.value_s(), 0.1, 0.004);
}

TEST_F(TurningOnTheSpot, IsNotLearnedWhereItIsKnown) {
  sweep_ = SweepDuration({}, {}, 0.05);
  Turn(0.1, 1.2, 12);
  EXPECT_EQ(sweep_.value_s(), 0.05);
}

TEST_F(TurningOnTheSpot, IsWhatTheLogTellsWhereThatFits) {
  sweep_.Tell(0.09);
  EXPECT_EQ(sweep_.value_s(), 0.09);
  Turn(0.1, 1.2, 12);
  EXPECT_EQ(sweep_.value_s(), 0.09);
}

TEST_F(TurningOnTheSpot, IsLearnedWhereTheLogTellsWhatCannotBe) {
  sweep_.Tell(0.01);  // as drivers do that take the time from point to point for another
  Turn(0.1, 1.2, 12);
  EXPECT_NEAR(sweep_.value_s(), 0.1, 0.01);
  sweep_.Tell(0.01);
  EXPECT_NEAR(sweep_.value_s(), 0.1, 0.01);
}

TEST_F(TurningOnTheSpot, PosesOfTwoFramesAreNotMixedUp) {
  for (int turn = 0; turn < 8; ++turn) {
    Turn(0.0, 1.2, 6);
    sweep_.BeginFrame();
    pose_ = pose_ * SE2{0.3, 0.2, 0.15};
  }
  EXPECT_EQ(sweep_.value_s(), 0.0);
}

TEST_F(TurningOnTheSpot, OfASlowLaserIsAsLongAsTheTimeBetweenScans) {
  interval_s_ = 0.3;
  for (int turn = 0; turn < 2; ++turn) Turn(0.3, turn % 2 == 0 ? 0.6 : -0.6, 12);
  EXPECT_NEAR(sweep_.value_s(), 0.3, 0.03);
}

TEST_F(TurningOnTheSpot, IsGivenUpWhereItWasChance) {
  Turn(0.1, 1.2, 9);
  ASSERT_NE(sweep_.value_s(), 0.0);
  for (int turn = 0; turn < 4; ++turn) Turn(0.0, turn % 2 == 0 ? 1.2 : -0.8, 12);
  EXPECT_EQ(sweep_.value_s(), 0.0);
}

}  // namespace
}  // namespace gmapping_spa::frontend
