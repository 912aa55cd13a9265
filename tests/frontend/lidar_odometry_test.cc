// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/lidar_odometry.h"

#include <gtest/gtest.h>

#include "tests/frontend/lidar_odometry_drive.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;
using sensor::BeamStatus;
using sensor::OdometryFault;

TEST(LidarOdometry, TheFirstScanIsNoMotion) {
  Drive drive(synthetic::Room());
  const ScanMotion motion = drive.To({1, 0, 0.3}, {{1, 2, 3}});
  EXPECT_TRUE((motion.motion == SE2{}));
  EXPECT_TRUE(motion.alternatives.empty());
  EXPECT_FALSE(motion.searched);
}

TEST(LidarOdometry, FindsTheMotionInSpiteOfWheelsThatSlip) {
  const SE2 slip{0.02, 0.005, 0.01};
  Drive drive(synthetic::Room());
  SE2 wheels = OnRound(0);
  for (int step = 0; step <= 160; ++step) {
    drive.To(OnRound(step), {StepOfRound(step) * slip});
    if (step > 0) wheels = wheels * StepOfRound(step) * slip;
  }
  ASSERT_GT(Between(OnRound(160), wheels).translation().norm(), 0.5);
  drive.ExpectIsWhereItIs(0.03, 0.01);
}

TEST(LidarOdometry, SaysNothingWhereAllIsWell) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 80; ++step) {
    const ScanMotion motion = drive.To(OnRound(step));
    EXPECT_TRUE(motion.matched) << step;
    EXPECT_TRUE(motion.alternatives.empty()) << step;
    EXPECT_FALSE(motion.wheels_rejected) << step;
    EXPECT_FALSE(motion.wheels_silent) << step;
  }
}

TEST(LidarOdometry, HonoursThePlaceOfTheLaserOnTheRobot) {
  Drive drive(synthetic::Room(), {.robot_T_laser = {0.4, -0.1, 0.3}});
  for (int step = 0; step <= 80; ++step) {
    drive.To(OnRound(step), {StepOfRound(step) * SE2{0.01, 0.005, 0.01}});
  }
  drive.ExpectIsWhereItIs(0.03, 0.01);
}

TEST(LidarOdometry, ForgetsOldMapsWithoutAJump) {
  LidarOdometry::Options options;
  options.map_scans = 4;  // a new map after every second scan entered
  Drive drive(synthetic::Room(), {}, options);
  for (int step = 0; step <= 160; ++step) {
    const ScanMotion motion = drive.To(OnRound(step), {StepOfRound(step) * SE2{0.01, 0, 0.005}});
    ExpectNear(motion.motion, StepOfRound(step), 0.03, 0.02);
  }
}

TEST(LidarOdometry, ScansWithoutAHitFollowTheWheels) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 40; ++step) drive.To(OnRound(step));
  for (const SE2 wheels : {SE2{0.1, 0, 0.05}, SE2{0.3, 0.1, -0.2}, SE2{}}) {
    const ScanMotion motion = drive.Take({}, drive.world_T_robot() * wheels, {wheels});
    EXPECT_LT(Log(Between(wheels, motion.motion)).norm(), 1e-9);
  }
}

TEST(LidarOdometry, ScansWithoutAHitAndWithoutWheelsGoOnAtTheSameVelocity) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 40; ++step) drive.To(OnRound(step));
  for (int step = 41; step <= 45; ++step) {
    const ScanMotion motion = drive.Take({}, OnRound(step), {{}, OdometryFault::kMissing});
    ExpectNear(motion.motion, StepOfRound(step), 0.02, 0.02);
  }
  for (int step = 46; step <= 80; ++step) drive.To(OnRound(step));
  drive.ExpectIsWhereItIs(0.05, 0.02);
}

TEST(LidarOdometry, GoesOnAfterScansWithoutAHit) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 40; ++step) drive.To(OnRound(step));
  for (int step = 41; step <= 44; ++step) drive.Take({}, OnRound(step), {StepOfRound(step)});
  for (int step = 45; step <= 80; ++step) {
    drive.To(OnRound(step), {StepOfRound(step) * SE2{0.01, 0, 0.01}});
  }
  drive.ExpectIsWhereItIs(0.03, 0.01);
}

TEST(LidarOdometry, ACoveredLaserLeavesThePoseToTheWheels) {
  sensor::LaserScan covered;
  for (int i = 0; i < 181; ++i) {
    covered.beams.push_back({(i - 90) * kDeg, 0.15, BeamStatus::kHit});
  }
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 40; ++step) drive.To(OnRound(step));
  for (int step = 41; step <= 44; ++step) {
    const ScanMotion motion = drive.Take(covered, OnRound(step), {StepOfRound(step)});
    EXPECT_FALSE(motion.matched) << step;
    ExpectNear(motion.motion, StepOfRound(step), 0.02, 0.02);
  }
  for (int step = 45; step <= 80; ++step) EXPECT_TRUE(drive.To(OnRound(step)).matched) << step;
  drive.ExpectIsWhereItIs(0.03, 0.01);
}

TEST(LidarOdometry, TheScanOfARepetitionIsNotLookedAt) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 40; ++step) drive.To(OnRound(step));
  const sensor::LaserScan frozen = drive.ScanAt(OnRound(40));
  for (int step = 41; step <= 50; ++step) {
    const ScanMotion motion =
        drive.Take(frozen, OnRound(step), {StepOfRound(step), OdometryFault::kRepeatedScan});
    EXPECT_TRUE((motion.motion == StepOfRound(step))) << step;
    EXPECT_FALSE(motion.matched) << step;
  }
  for (int step = 51; step <= 80; ++step) drive.To(OnRound(step));
  drive.ExpectIsWhereItIs(0.03, 0.01);
}

// Niches every half metre, of which the laser sees the same wherever it stands.
synthetic::Walls Niches() {
  std::vector<Eigen::Vector2d> comb;
  for (int i = -60; i < 60; ++i) {
    const double x = 0.5 * i;
    comb.insert(comb.end(), {{x, 2.0}, {x + 0.25, 2.0}, {x + 0.25, 2.3}, {x + 0.5, 2.3}});
  }
  synthetic::Walls walls;
  for (std::size_t i = 0; i + 1 < comb.size(); ++i) {
    walls.push_back({comb[i], comb[i + 1]});
    walls.push_back({-comb[i], -comb[i + 1]});
  }
  return walls;
}
constexpr synthetic::Laser kAllAround{
    .beams = 360, .field_of_view_rad = 359 * kDeg, .usable_range_m = 6.0};

TEST(LidarOdometry, PlacesThatFitAlikeComeBackAsAlternatives) {
  Drive drive(Niches(), kAllAround);
  for (int step = 0; step <= 10; ++step) drive.To({0, 0, 0});
  const ScanMotion motion = drive.To({0.25, 0, 0}, {{}, OdometryFault::kRestart});
  EXPECT_TRUE(motion.searched);
  ASSERT_GE(motion.alternatives.size(), 2u);
  double sum = 0.0, forward = 0.0, backward = 0.0;
  for (const auto& alternative : motion.alternatives) {
    sum += alternative.probability;
    const double x = alternative.motion.x;
    if (std::abs(x - 0.25) < 0.05) forward = alternative.probability;
    if (std::abs(x + 0.25) < 0.05) backward = alternative.probability;
  }
  EXPECT_NEAR(sum, 1.0, 1e-9);
  EXPECT_GT(forward, 0.1);
  EXPECT_GT(backward, 0.1);
  EXPECT_TRUE((motion.motion == motion.alternatives.front().motion));
}

// The map is forgotten where no place is likelier, and what fits along the way is not asked of it.
TEST(LidarOdometry, GoesOnWhereItForgetsTheMapAndHasMovedOn) {
  LidarOdometry::Options options;
  options.insert_m = 0.1;
  Drive drive(Niches(), kAllAround, options);
  for (int step = 0; step <= 10; ++step) drive.To({0, 0, 0});
  const ScanMotion motion = drive.To({0.25, 0, 0}, {{}, OdometryFault::kRestart});
  EXPECT_GE(motion.alternatives.size(), 2u);
  EXPECT_FALSE(motion.unchecked);
}

}  // namespace
}  // namespace gmapping_spa::frontend
