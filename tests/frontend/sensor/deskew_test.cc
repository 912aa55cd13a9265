// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/deskew.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/frontend/moving_laser.h"

namespace gmapping_spa::sensor {
namespace {

using backend::SE2;

TEST(PlaceInSweep, RunsFromMinusAHalfToAHalf) {
  LaserScan scan;
  scan.beams.resize(5);
  EXPECT_EQ(PlaceInSweep(scan, 0), -0.5);
  EXPECT_EQ(PlaceInSweep(scan, 2), 0.0);
  EXPECT_EQ(PlaceInSweep(scan, 4), 0.5);
  scan.beams.resize(1);
  EXPECT_EQ(PlaceInSweep(scan, 0), 0.0);
}

TEST(PlaceInSweep, BeginsAtTheStampWhereTheLogTellsTheSweep) {
  LaserScan scan;
  scan.sweep_s = 0.1;
  scan.beams.resize(5);
  EXPECT_EQ(PlaceInSweep(scan, 0), 0.0);
  EXPECT_EQ(PlaceInSweep(scan, 4), 1.0);
}

TEST(Deskew, LeavesScansOfARobotThatStandsStill) {
  const LaserScan scan = synthetic::Scan(synthetic::Room(), {0.3, 0.2, 1.0});
  const LaserScan same = Deskew(scan, Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < scan.beams.size(); ++k) {
    EXPECT_EQ(same.beams[k].angle_rad, scan.beams[k].angle_rad);
    EXPECT_EQ(same.beams[k].range_m, scan.beams[k].range_m);
  }
}

// All that is seen lies on a wall, as seen from that pose.
void ExpectOnWalls(const LaserScan& scan, const SE2& world_T_robot, double tolerance_m) {
  const synthetic::Walls walls = synthetic::Room();
  for (const Beam& beam : scan.beams) {
    const double range_m =
        synthetic::Range(walls, world_T_robot * scan.robot_T_laser * SE2{0, 0, beam.angle_rad});
    // A corner may stand between where the laser was and where it is there.
    if (std::abs(range_m - beam.range_m) > 0.3) continue;
    EXPECT_NEAR(beam.range_m, range_m, tolerance_m) << beam.angle_rad;
  }
}

TEST(Deskew, PutsWhatATurningAndDrivingRobotSeesBackOntoTheWalls) {
  const Eigen::Vector3d motion(0.15, 0.02, 0.2);
  const SE2 middle{0.4, -0.3, 0.8};
  for (const SE2& mounting : {SE2{}, SE2{0.3, -0.1, 2.0}}) {
    const LaserScan bent =
        synthetic::ScanOnTheMove(synthetic::Room(), middle, motion, {.robot_T_laser = mounting});
    ExpectOnWalls(Deskew(bent, motion), middle, 1e-9);
  }
}

TEST(Deskew, PutsBeamsToTheFirstOneWhereTheLogTellsTheSweep) {
  const Eigen::Vector3d motion(0.15, 0.02, 0.2);
  const SE2 first{0.4, -0.3, 0.8};
  LaserScan bent =
      synthetic::ScanOnTheMove(synthetic::Room(), first * backend::Exp(0.5 * motion), motion);
  bent.sweep_s = 0.1;
  ExpectOnWalls(Deskew(bent, motion), first, 1e-9);
}

TEST(Deskew, TurnsBeamsWithoutAReturnAlong) {
  LaserScan scan;
  for (int k = 0; k < 3; ++k) scan.beams.push_back({0.1 * k, 20.0, BeamStatus::kNoReturn});
  const LaserScan turned = Deskew(scan, {1.0, 0.0, 0.2});
  EXPECT_DOUBLE_EQ(turned.beams[0].angle_rad, -0.1);
  EXPECT_DOUBLE_EQ(turned.beams[1].angle_rad, 0.1);
  EXPECT_DOUBLE_EQ(turned.beams[2].angle_rad, 0.3);
  EXPECT_EQ(turned.beams[0].range_m, 20.0);
  EXPECT_EQ(turned.beams[0].status, BeamStatus::kNoReturn);
}

TEST(Deskew, AnglesGoOnBeyondHalfATurn) {
  LaserScan scan;
  for (int k = 0; k <= 10; ++k) scan.beams.push_back({3.0 + 0.05 * k, 5.0, BeamStatus::kHit});
  const LaserScan turned = Deskew(scan, {0.0, 0.0, 0.1});
  for (int k = 1; k <= 10; ++k) {
    EXPECT_NEAR(turned.beams[k].angle_rad - turned.beams[k - 1].angle_rad, 0.06, 1e-9);
  }
}

}  // namespace
}  // namespace gmapping_spa::sensor
