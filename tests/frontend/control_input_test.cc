// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/control_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/frontend/lidar_odometry_drive.h"
#include "tests/frontend/moving_laser.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// Drives the round of Drive; the odometry stands in the scans.
class ControlInputInARoom : public testing::Test {
 protected:
  void Start(OdometrySource source) {
    ControlInput::Options options;
    options.source = source;
    control_ = std::make_unique<ControlInput>(options, &health_);
  }

  sensor::LaserScan ScanAt(int step) {
    sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), OnRound(step));
    scan.stamp_s = 100.0 + 0.1 * step;
    scan.odom_T_robot = odom_T_world_ * OnRound(step);
    return scan;
  }

  ScanMotion Take(const sensor::LaserScan& scan) {
    const ScanMotion motion = control_->AddScan(scan);
    world_T_estimate_ = world_T_estimate_ * motion.motion;
    return motion;
  }

  void DriveUpTo(int last) {
    while (step_ <= last) Take(ScanAt(step_++));
  }

  std::vector<std::string> Findings() const {
    std::vector<std::string> kinds;
    for (const auto& [kind, finding] : health_.findings()) kinds.push_back(kind);
    return kinds;
  }
  using Kinds = std::vector<std::string>;

  Health health_;
  std::unique_ptr<ControlInput> control_;
  SE2 odom_T_world_{3, -2, 0.7};
  SE2 world_T_estimate_ = OnRound(0);
  int step_ = 0;
};

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

TEST_F(ControlInputInARoom, SaysOnceThatScansAreDeskewed) {
  Start(OdometrySource::kLidar);
  constexpr double kSweep_s = 0.08, kInterval_s = 0.1;
  SE2 pose;
  for (int k = 0; k < 60; ++k) {
    const Eigen::Vector3d velocity(0.0, 0.0, k < 20 ? 0.0 : 1.0);
    pose = pose * backend::Exp(kInterval_s * velocity);
    sensor::LaserScan scan = synthetic::ScanOnTheMove(synthetic::Room(), pose, kSweep_s * velocity);
    scan.stamp_s = 100.0 + kInterval_s * k;
    scan.odom_T_robot = pose;
    Take(scan);
  }
  EXPECT_EQ(Findings(), Kinds{"scans_deskewed"});
  EXPECT_EQ(health_.findings().at("scans_deskewed").count, 1);
  EXPECT_THAT(health_.findings().at("scans_deskewed").message, testing::HasSubstr(" ms"));
  EXPECT_NEAR(control_->sweep_s(), kSweep_s, 0.01);
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
