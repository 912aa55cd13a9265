// SPDX-License-Identifier: BSD-3-Clause
// What ControlInput reports of odometry and scans that are at fault.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "frontend/control_input.h"
#include "tests/frontend/control_input_room.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

TEST_F(ControlInputInARoom, AnImpossibleStepIsLeftOutAndReportedWithItsTime) {
  for (const OdometrySource source : {OdometrySource::kWheel, OdometrySource::kLidar}) {
    health_ = {};
    Start(source);
    step_ = 0;
    world_T_estimate_ = OnRound(0);
    DriveUpTo(40);
    odom_T_world_ = SE2{70, 20, 1} * odom_T_world_;
    DriveUpTo(80);
    EXPECT_EQ(Findings(), Kinds{"odometry_impossible"});
    EXPECT_EQ(health_.findings().at("odometry_impossible").count, 1);
    EXPECT_DOUBLE_EQ(health_.findings().at("odometry_impossible").first_stamp_s, 104.1);
    // One step of 0.1 m is missing where there are but wheels.
    const double bound_m = source == OdometrySource::kWheel ? 0.15 : 0.03;
    ExpectNear(world_T_estimate_, OnRound(80), bound_m,
               source == OdometrySource::kWheel ? 0.1 : 0.01);
  }
}

TEST_F(ControlInputInARoom, ARestartIsReported) {
  Start(OdometrySource::kLidar);
  DriveUpTo(39);
  odom_T_world_ = Inverse(OnRound(40));
  DriveUpTo(80);
  EXPECT_EQ(Findings(), Kinds{"odometry_restart"});
  EXPECT_DOUBLE_EQ(health_.findings().at("odometry_restart").first_stamp_s, 104.0);
  ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
}

TEST_F(ControlInputInARoom, SilentWheelsAreReported) {
  Start(OdometrySource::kLidar);
  DriveUpTo(40);
  for (; step_ <= 80; ++step_) {
    sensor::LaserScan scan = ScanAt(step_);
    scan.odom_T_robot = odom_T_world_ * OnRound(40);
    Take(scan);
  }
  EXPECT_EQ(Findings(), Kinds{"odometry_silent"});
  EXPECT_GT(health_.findings().at("odometry_silent").count, 30);
  ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
}

TEST_F(ControlInputInARoom, WheelsThatTellTurnsOnlyAreReported) {
  Start(OdometrySource::kLidar);
  for (; step_ <= 80; ++step_) {
    sensor::LaserScan scan = ScanAt(step_);
    scan.odom_T_robot = {0.0, 0.0, scan.odom_T_robot.theta};
    Take(scan);
  }
  EXPECT_EQ(Findings(), Kinds{"odometry_turns_only"});
  EXPECT_GT(health_.findings().at("odometry_turns_only").count, 60);
  ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
}

TEST_F(ControlInputInARoom, SaysOnceThatTurnsAreCorrected) {
  Start(OdometrySource::kLidar);
  SE2 odom_T_robot;
  for (; step_ <= 800; ++step_) {
    sensor::LaserScan scan = ScanAt(step_);
    if (step_ > 0) {
      const SE2 motion = Between(OnRound(step_ - 1), OnRound(step_));
      odom_T_robot = odom_T_robot * SE2{motion.x, motion.y, motion.theta + 0.06 * motion.x};
    }
    scan.odom_T_robot = odom_T_robot;
    Take(scan);
  }
  EXPECT_EQ(Findings(), Kinds{"odometry_calibrated"});
  EXPECT_EQ(health_.findings().at("odometry_calibrated").count, 1);
  EXPECT_THAT(health_.findings().at("odometry_calibrated").message,
              testing::HasSubstr("deg per m driven"));
}

TEST_F(ControlInputInARoom, OdometryInOtherUnitsIsReportedOnceAndCorrected) {
  for (const OdometrySource source : {OdometrySource::kWheel, OdometrySource::kLidar}) {
    health_ = {};
    Start(source);
    step_ = 0;
    world_T_estimate_ = OnRound(0);
    SE2 halfway;
    for (int k = 0; k <= 160; ++k) {
      sensor::LaserScan scan = ScanAt(k);
      scan.odom_T_robot.x /= 0.001;
      scan.odom_T_robot.y /= 0.001;
      Take(scan);
      if (k == 80) halfway = world_T_estimate_;
    }
    EXPECT_EQ(health_.findings().at("odometry_scaled").count, 1);
    EXPECT_THAT(health_.findings().at("odometry_scaled").message,
                testing::HasSubstr("1000.00 times as long as the scans show, as in millimeters"));
    ExpectNear(Between(halfway, world_T_estimate_), Between(OnRound(80), OnRound(160)), 0.03, 0.02);
  }
}

TEST_F(ControlInputInARoom, AContradictionIsReported) {
  Start(OdometrySource::kLidar);
  DriveUpTo(40);
  odom_T_world_ = odom_T_world_ * OnRound(40) * SE2{0, 0, 0.5} * Inverse(OnRound(40));
  DriveUpTo(80);
  EXPECT_EQ(Findings(), Kinds{"odometry_contradicted"});
  EXPECT_EQ(health_.findings().at("odometry_contradicted").count, 1);
  ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
}

TEST_F(ControlInputInARoom, ARepeatedScanIsReportedAndIsNotCalledLost) {
  Start(OdometrySource::kLidar);
  DriveUpTo(40);
  for (; step_ <= 45; ++step_) {
    sensor::LaserScan frozen = ScanAt(step_);
    frozen.beams = ScanAt(40).beams;
    Take(frozen);
  }
  DriveUpTo(80);
  EXPECT_EQ(Findings(), Kinds{"repeated_scan"});
  EXPECT_EQ(health_.findings().at("repeated_scan").count, 5);
  EXPECT_TRUE(health_.stretches().empty());
  ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
}

TEST_F(ControlInputInARoom, ALogWithoutOdometryIsReported) {
  Start(OdometrySource::kLidar);
  for (; step_ <= 80; ++step_) {
    sensor::LaserScan scan = ScanAt(step_);
    scan.has_odometry = false;
    Take(scan);
  }
  EXPECT_EQ(Findings(), Kinds{"odometry_missing"});
  ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
}

TEST_F(ControlInputInARoom, LidarOnlyNeverLooksAtTheOdometry) {
  Start(OdometrySource::kLidarOnly);
  for (; step_ <= 80; ++step_) {
    sensor::LaserScan scan = ScanAt(step_);
    scan.odom_T_robot = {1e3 * std::sin(9.0 * step_), std::nan(""), 2.0 * step_};
    Take(scan);
  }
  EXPECT_EQ(Findings(), Kinds{});
  ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
}

TEST_F(ControlInputInARoom, ACoveredLaserIsALostStretch) {
  Start(OdometrySource::kLidar);
  DriveUpTo(40);
  for (; step_ <= 44; ++step_) {
    sensor::LaserScan covered = ScanAt(step_);
    for (sensor::Beam& beam : covered.beams) {
      beam.range_m = 0.15 + 1e-3 * (step_ % 2);
    }
    EXPECT_FALSE(Take(covered).matched);
  }
  DriveUpTo(80);
  EXPECT_EQ(Findings(), Kinds{"unmatched_scan"});
  ASSERT_EQ(health_.stretches().count("lost"), 1u);
  const std::vector<Stretch>& lost = health_.stretches().at("lost");
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_DOUBLE_EQ(lost.front().begin_s, 104.1);
  EXPECT_DOUBLE_EQ(lost.front().end_s, 104.4);
  ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
}

}  // namespace
}  // namespace gmapping_spa::frontend
