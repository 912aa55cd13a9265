// SPDX-License-Identifier: BSD-3-Clause
// Places that leave a direction open, and scans of few beams: odometry without error is kept.
#include <gtest/gtest.h>

#include "tests/frontend/lidar_odometry_drive.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// The way of a robot that starts gently and goes on at 1 m/s, after so many scans.
double Way(int step) {
  constexpr int kStart = 20;  // scans, at ten a second
  return step < kStart ? 0.05 * step * step / kStart : 0.1 * step - 0.05 * kStart;
}

// Along Corridor(direction) from x = 0, forwards or in reverse. `facing`: of the robot, relative to
// the way it drives.
class LidarOdometryInACorridor : public testing::TestWithParam<double> {
 protected:
  void DriveAlong(Drive* drive, double facing_rad, int steps) {
    const SE2 along{0, 0, GetParam()};
    for (int step = 0; step <= steps; ++step) {
      drive->To(along * SE2{Way(step), 0.1, facing_rad});
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Direction, LidarOdometryInACorridor, testing::Values(0.0, 0.35, -0.8));

TEST_P(LidarOdometryInACorridor, ExactWheelsAreKeptForwards) {
  Drive drive(synthetic::Corridor(GetParam()));
  DriveAlong(&drive, 0.0, 100);
  drive.ExpectIsWhereItIs(0.02, 0.01);
}

TEST_P(LidarOdometryInACorridor, ExactWheelsAreKeptInReverse) {
  Drive drive(synthetic::Corridor(GetParam()));
  DriveAlong(&drive, std::numbers::pi, 100);
  drive.ExpectIsWhereItIs(0.02, 0.01);
}

TEST_P(LidarOdometryInACorridor, ExactWheelsAreKeptInReverseFromTheEndThatIsSeen) {
  synthetic::Walls walls = synthetic::Corridor(GetParam());
  const SE2 rotation{0, 0, GetParam()};
  walls.push_back({rotation * Eigen::Vector2d(-2, -1), rotation * Eigen::Vector2d(-2, 1)});
  Drive drive(walls);
  DriveAlong(&drive, std::numbers::pi, 100);
  drive.ExpectIsWhereItIs(0.02, 0.01);
}

TEST_P(LidarOdometryInACorridor, WheelsThatFreezeAtFullSpeedDoNotStopTheRobot) {
  Drive drive(synthetic::Corridor(GetParam()));
  const SE2 along{0, 0, GetParam()};
  int silent = 0;
  for (int step = 0; step <= 100; ++step) {
    const SE2 pose = along * SE2{Way(step), 0.1, 0};
    const bool is_frozen = step > 60 && step <= 80;
    const Wheels unchanged{{}, sensor::OdometryFault::kUnchanged};
    silent += (is_frozen ? drive.To(pose, unchanged) : drive.To(pose)).wheels_silent ? 1 : 0;
  }
  EXPECT_EQ(silent, 20);
  drive.ExpectIsWhereItIs(0.3, 0.01);
}

TEST_P(LidarOdometryInACorridor, WheelsThatSlipAcrossItAreCorrected) {
  Drive drive(synthetic::Corridor(GetParam()));
  const SE2 along{0, 0, GetParam()};
  for (int step = 0; step <= 60; ++step) {
    const double driven_m = step == 0 ? 0.0 : Way(step) - Way(step - 1);
    drive.To(along * SE2{Way(step), 0, 0}, {{driven_m, 0.02 * driven_m, 0.03 * driven_m}});
  }
  drive.ExpectIsWhereItIs(0.12, 0.01);
  EXPECT_NEAR(Between(along, drive.world_T_estimate()).y, 0.0, 0.02);
}

// Past door frames, on a way that winds a little.
TEST_P(LidarOdometryInACorridor, WheelsThatTellTurnsOnlyDoNotHoldTheRobotBack) {
  synthetic::Walls walls = synthetic::Corridor(GetParam());
  const SE2 along{0, 0, GetParam()};
  for (double x = -6.5; x < 20.0; x += 5.0) {
    for (const double end : {x, x + 0.9}) {
      walls.push_back({along * Eigen::Vector2d(end, 0.75), along * Eigen::Vector2d(end, 1.0)});
    }
  }
  Drive drive(walls, {.usable_range_m = 8.0});
  for (int step = 0; step <= 100; ++step) {
    const double turn_rad = 0.02 * std::sin(0.3 * step);
    const double before_rad = 0.02 * std::sin(0.3 * (step - 1));
    const ScanMotion motion =
        drive.To(along * SE2{Way(step), 0.1, turn_rad}, {{0, 0, turn_rad - before_rad}});
    EXPECT_TRUE(motion.wheels_turn_only || step < 20) << step;
  }
  drive.ExpectIsWhereItIs(0.1, 0.01);
}

TEST(LidarOdometryWithFewBeams, ExactWheelsAreKept) {
  // In a corridor with an end and niches.
  synthetic::Walls walls;
  synthetic::AddPolygon({{-2, -1}, {12, -1}, {12, 1}, {7, 1}, {7, 1.5}, {6, 1.5}, {6, 1}, {-2, 1}},
                        0.2, &walls);
  for (const int beams : {16, 24, 36}) {
    Drive drive(
        walls, {.beams = beams, .field_of_view_rad = 2.0 * std::numbers::pi * (beams - 1) / beams});
    const SE2 along{0, 0, 0.2};
    for (int step = 0; step <= 80; ++step) drive.To(along * SE2{Way(step), 0.1, 0});
    SCOPED_TRACE(beams);
    const SE2 off = Between(drive.world_T_robot(), drive.world_T_estimate());
    EXPECT_NEAR(off.x, 0.0, 0.1);  // of 8 m: each of many scans in the map adds its own error
    EXPECT_NEAR(off.y, 0.0, 0.08);
    EXPECT_NEAR(off.theta, 0.0, 0.02);
  }
}

TEST(LidarOdometryWithFewBeams, WheelsThatTurnTooFarAllTheTimeDoNotBendThePath) {
  constexpr double kTooFar_rad_per_m = 0.06;
  Drive drive(synthetic::Corridor(0.35), {.beams = 18});
  const SE2 along{0, 0, 0.35};
  for (int step = 0; step <= 600; ++step) {
    const double driven_m = step == 0 ? 0.0 : Way(step) - Way(step - 1);
    drive.To(along * SE2{Way(step), 0.1, 0}, {{driven_m, 0, kTooFar_rad_per_m * driven_m}});
  }
  EXPECT_NEAR(Between(drive.world_T_robot(), drive.world_T_estimate()).theta, 0.0, 0.1);
}

TEST_P(LidarOdometryInACorridor, WhatNeitherScansNorWheelsTellIsKnown) {
  const Wheels missing{{}, sensor::OdometryFault::kMissing};
  const auto count = [&](synthetic::Walls walls, bool wheels) {
    Drive drive(std::move(walls));
    int unobserved = 0;
    for (int step = 0; step <= 60; ++step) {
      const SE2 pose = SE2{0, 0, GetParam()} * SE2{0.02 * step, 0.1, 0.0};
      unobserved += (wheels ? drive.To(pose) : drive.To(pose, missing)).unobserved ? 1 : 0;
    }
    return unobserved;
  };
  EXPECT_GT(count(synthetic::Corridor(GetParam()), false), 50);
  EXPECT_EQ(count(synthetic::Corridor(GetParam()), true), 0);
  EXPECT_EQ(count(synthetic::Room(), false), 0);
}

TEST_P(LidarOdometryInACorridor, WhatTheWheelsAloneTellIsKnown) {
  const auto unchecked = [&](const synthetic::Walls& walls) {
    Drive drive(walls);
    int count = 0;
    for (int step = 0; step <= 60; ++step) {
      count += drive.To(SE2{0, 0, GetParam()} * SE2{0.05 * step - 1.5, 0.1, 0.0}).unchecked ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(unchecked(synthetic::Corridor(GetParam())), 40);
  EXPECT_EQ(unchecked(synthetic::Room()), 0);
}

}  // namespace
}  // namespace gmapping_spa::frontend
