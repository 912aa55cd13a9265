// SPDX-License-Identifier: BSD-3-Clause
// Where a scan is looked for that does not fit where it was expected.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "tests/frontend/lidar_odometry_drive.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// Four walls that look alike: the whole window holds four poses that fit.
synthetic::Walls Square() {
  synthetic::Walls walls;
  synthetic::AddPolygon({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, 0.0, &walls);
  return walls;
}

// Between two scans the robot turns back, and the wheels are off by more than alignment makes good.
TEST(LidarOdometrySearch, ATurnBetweenTwoScansIsFoundNearWhatTheWheelsSay) {
  for (const double turn_rad : {-2.9, -2.2, 2.2, 2.9}) {
    SCOPED_TRACE(turn_rad);
    Drive drive(Square(), {.field_of_view_rad = std::numbers::pi});
    for (int step = 0; step <= 80; ++step) drive.To(OnRound(step));
    const SE2 turn{-0.4, 0.1, turn_rad};
    drive.To(drive.world_T_robot() * turn, {turn * SE2{0.15, 0.15, 0.3}});
    drive.ExpectIsWhereItIs(0.05, 0.02);
  }
}

TEST(LidarOdometrySearch, AStepThatTheWheelsMissIsFound) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 80; ++step) drive.To(OnRound(step));
  const ScanMotion motion = drive.To(drive.world_T_robot() * SE2{0.4, 0.1, 0.6}, {StepOfRound(1)});
  EXPECT_TRUE(motion.searched);
  EXPECT_TRUE(motion.wheels_rejected);
  drive.ExpectIsWhereItIs(0.03, 0.02);
}

// Posts all around, 6 degrees apart, some of which are missing, before a round wall.
synthetic::Walls Posts() {
  synthetic::Walls walls;
  std::vector<Eigen::Vector2d> round;
  for (int k = 0; k < 90; ++k) round.push_back(SE2{0, 0, k * 4.0 * kDeg} * Eigen::Vector2d(6, 0));
  synthetic::AddPolygon(round, 0.0, &walls);
  for (int k = 0; k < 60; ++k) {
    if (k % 5 == 0 || k % 13 == 7 || k % 11 == 3) continue;
    const SE2 post = SE2{0, 0, k * 6.0 * kDeg} * SE2{4, 0, 0};
    synthetic::AddPolygon(
        {post * Eigen::Vector2d(-0.05, -0.05), post * Eigen::Vector2d(0.05, -0.05),
         post * Eigen::Vector2d(0.05, 0.05), post * Eigen::Vector2d(-0.05, 0.05)},
        0.0, &walls);
  }
  return walls;
}

TEST(LidarOdometrySearch, AfterATurnThatIsKnownBadlyTheNextPeakIsNotTakenForTheBest) {
  for (const double off_rad : {-0.1, 0.1}) {
    SCOPED_TRACE(off_rad);
    Drive drive(Posts(), {.beams = 721, .field_of_view_rad = 2.0 * std::numbers::pi});
    for (int step = 0; step <= 20; ++step) drive.To({0.02 * step, 0, 0.01 * step});
    for (int turn = 1; turn <= 5; ++turn) {
      const SE2 motion{0.02, 0, 0.7};
      const SE2 told{0.02, 0, 0.7 + off_rad};
      EXPECT_TRUE(drive.To(drive.world_T_robot() * motion, {told}).searched) << turn;
      drive.ExpectIsWhereItIs(0.03, 0.03);
    }
  }
}

// Two walls 3 m apart with the same pillar every 0.8 m.
synthetic::Walls Gallery(double direction_rad) {
  synthetic::Walls walls;
  for (const double side : {-1.0, 1.0}) {
    std::vector<Eigen::Vector2d> comb;
    for (int k = -60; k < 60; ++k) {
      const double x = 0.8 * k;
      comb.insert(
          comb.end(),
          {{x, side * 1.5}, {x + 0.6, side * 1.5}, {x + 0.6, side * 1.3}, {x + 0.8, side * 1.3}});
    }
    comb.insert(comb.end(), {{48, side * 3}, {-48, side * 3}});
    synthetic::AddPolygon(comb, direction_rad, &walls);
  }
  return walls;
}

// At the right place most of the scan is new; where it stood before, the robot has seen all of it.
TEST(LidarOdometrySearch, AfterAGapTheRobotIsNotPutBackToWhereItSawTheSame) {
  for (const double direction_rad : {0.0, 0.35, -2.0}) {
    SCOPED_TRACE(direction_rad);
    Drive drive(Gallery(direction_rad),
                {.beams = 241, .field_of_view_rad = 240 * kDeg, .usable_range_m = 5.6});
    const SE2 world_T_gallery{0, 0, direction_rad};
    const auto drive_on = [&](int steps) {
      for (int step = 0; step < steps; ++step) drive.To(drive.world_T_robot() * SE2{0.15, 0, 0});
    };
    drive.To(world_T_gallery * SE2{-10, 0, 0});
    drive_on(60);
    drive.Wait(2.0);
    EXPECT_TRUE(drive.To(drive.world_T_robot() * SE2{3.15, 0, 0}, {SE2{3.2, 0.1, 0.02}}).searched);
    drive_on(10);
    drive.ExpectIsWhereItIs(0.1, 0.02);
  }
}

TEST(LidarOdometrySearch, NothingIsSearchedWhereTheGuessesDo) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 80; ++step) EXPECT_FALSE(drive.To(OnRound(step)).searched) << step;
}

}  // namespace
}  // namespace gmapping_spa::frontend
