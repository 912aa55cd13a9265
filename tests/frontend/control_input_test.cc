// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/control_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/frontend/control_input_room.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

TEST_F(ControlInputInARoom, NothingIsReportedWhereAllIsWell) {
  for (const OdometrySource source :
       {OdometrySource::kWheel, OdometrySource::kLidar, OdometrySource::kLidarOnly}) {
    Start(source);
    step_ = 0;
    world_T_estimate_ = OnRound(0);
    DriveUpTo(80);
    EXPECT_EQ(Findings(), Kinds{}) << static_cast<int>(source);
    EXPECT_TRUE(health_.stretches().empty());
    ExpectNear(world_T_estimate_, OnRound(80), 0.03, 0.01);
  }
}

class ControlInputOfASlowLaser : public ControlInputInARoom {
 protected:
  // So many scans of a robot that stands still, and of one that turns.
  void StandAndTurn(double sweep_s, int stand, int turn) {
    constexpr double kInterval_s = 0.1;
    for (int k = 0; k < stand + turn; ++k) {
      const Eigen::Vector3d velocity(0.0, 0.0, k < stand ? 0.0 : 1.0);
      pose_ = pose_ * backend::Exp(kInterval_s * velocity);
      sensor::LaserScan scan =
          synthetic::ScanOnTheMove(synthetic::Room(), pose_, sweep_s * velocity);
      scan.stamp_s = stamp_s_ += kInterval_s;
      scan.odom_T_robot = pose_;
      Take(scan);
    }
  }

  SE2 pose_;
  double stamp_s_ = 100.0;
};

TEST_F(ControlInputOfASlowLaser, SaysOnceThatScansAreDeskewed) {
  Start(OdometrySource::kLidar);
  constexpr double kSweep_s = 0.08;
  StandAndTurn(kSweep_s, 20, 40);
  EXPECT_EQ(Findings(), Kinds{"scans_deskewed"});
  EXPECT_EQ(health_.findings().at("scans_deskewed").count, 1);
  EXPECT_THAT(health_.findings().at("scans_deskewed").message, testing::HasSubstr(" ms"));
  EXPECT_NEAR(control_->sweep_s(), kSweep_s, 0.01);
}

TEST_F(ControlInputOfASlowLaser, SaysThatItWasNone) {
  Start(OdometrySource::kLidar);
  StandAndTurn(0.08, 20, 8);
  for (int turn = 0; turn < 4; ++turn) StandAndTurn(0.0, 10, 12);
  EXPECT_EQ(Findings(), (Kinds{"scans_deskewed", "sweep_given_up"}));
  EXPECT_EQ(health_.findings().at("sweep_given_up").count, 1);
  EXPECT_EQ(control_->sweep_s(), 0.0);
}

TEST_F(ControlInputInARoom, WheelsAreTakenAsTheyAreIfThatIsAskedForButNotWithoutAWord) {
  Start(OdometrySource::kWheel);
  DriveUpTo(20);
  odom_T_world_ = SE2{3, -2, 0.7} * OnRound(20) * SE2{0.05, 0.02, 0.1} * Inverse(OnRound(20));
  const SE2 wheels = Between(SE2{3, -2, 0.7} * OnRound(20), odom_T_world_ * OnRound(21));
  ExpectNear(Take(ScanAt(21)).motion, wheels, 1e-9, 1e-9);
  EXPECT_EQ(Findings(), Kinds{"odometry_contradicted"});
}

TEST_F(ControlInputInARoom, RawOdometryIsTakenWhateverItSays) {
  Start(OdometrySource::kRaw);
  DriveUpTo(20);
  EXPECT_EQ(Findings(), Kinds{});
  const SE2 jump{0.2, 0.1, 1.0};
  odom_T_world_ = odom_T_world_ * OnRound(20) * jump * Inverse(OnRound(20));
  const ScanMotion motion = Take(ScanAt(21));
  ExpectNear(motion.motion, jump * Between(OnRound(20), OnRound(21)), 1e-9, 1e-9);
  EXPECT_EQ(motion.noise, 1.0);  // however well the wheels did before
  EXPECT_EQ(Findings(), Kinds{"odometry_impossible"});
  EXPECT_THAT(health_.findings().at("odometry_impossible").message,
              testing::HasSubstr("used all the same"));
}

TEST_F(ControlInputInARoom, RawOdometryThatStandsStillWhileTheRobotDrivesIsReported) {
  Start(OdometrySource::kRaw);
  DriveUpTo(20);
  const SE2 stuck = ScanAt(20).odom_T_robot;
  for (int k = 21; k < 40; ++k) {
    sensor::LaserScan scan = ScanAt(k);
    scan.odom_T_robot = stuck;
    Take(scan);
  }
  EXPECT_EQ(Findings(), Kinds{"odometry_silent"});
}

TEST_F(ControlInputInARoom, RawOdometryOverScansWithoutComesWithTheNextOne) {
  Start(OdometrySource::kRaw);
  DriveUpTo(20);
  sensor::LaserScan without = ScanAt(21);
  without.has_odometry = false;
  EXPECT_TRUE(Take(without).motion == SE2{});
  ExpectNear(Take(ScanAt(22)).motion, Between(OnRound(20), OnRound(22)), 1e-9, 1e-9);
  EXPECT_EQ(Findings(), Kinds{"odometry_missing"});
}

TEST_F(ControlInputInARoom, ABlindScanIsReported) {
  Start(OdometrySource::kLidar);
  DriveUpTo(20);
  sensor::LaserScan blind = ScanAt(21);
  for (sensor::Beam& beam : blind.beams) beam.status = sensor::BeamStatus::kInvalid;
  Take(blind);
  EXPECT_EQ(Findings(), Kinds{"blind_scan"});
  EXPECT_EQ(health_.findings().at("blind_scan").count, 1);
}

TEST_F(ControlInputInARoom, BlindScansAtTheBeginAreReportedWithTheFirstThatIsNot) {
  Start(OdometrySource::kLidar);
  for (; step_ < 3; ++step_) {
    sensor::LaserScan blind = ScanAt(step_);
    for (sensor::Beam& beam : blind.beams) beam.status = sensor::BeamStatus::kNoReturn;
    Take(blind);
    EXPECT_EQ(Findings(), Kinds{});
  }
  DriveUpTo(10);
  EXPECT_EQ(health_.findings().at("blind_scan").count, 3);
  EXPECT_DOUBLE_EQ(health_.findings().at("blind_scan").first_stamp_s, 100.0);
}

TEST_F(ControlInputInARoom, WheelsThatAreBelievedDoNotHideThatNothingFits) {
  Start(OdometrySource::kWheel);
  DriveUpTo(20);
  for (int step = 21; step < 25; ++step) {
    sensor::LaserScan elsewhere = ScanAt(step);
    for (sensor::Beam& beam : elsewhere.beams) beam.range_m *= beam.angle_rad > 0 ? 0.3 : 2.5;
    ExpectNear(Take(elsewhere).motion, Between(OnRound(step - 1), OnRound(step)), 1e-9, 1e-9);
  }
  EXPECT_GE(health_.findings().count("unmatched_scan"), 1u);
}

}  // namespace
}  // namespace gmapping_spa::frontend
