// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

sensor::LaserScan ScanAt(std::int64_t index, const SE2& odom_T_robot) {
  sensor::LaserScan scan;
  scan.index = index;
  scan.stamp_s = 100.0 + static_cast<double>(index);
  scan.odom_T_robot = odom_T_robot;
  return scan;
}

void Add(int index, const SE2& odom_T_robot, double motion, bool is_update, ScanPoses* poses) {
  poses->Add(ScanAt(index, odom_T_robot), odom_T_robot, motion, is_update);
}

void ExpectNear(const SE2& pose, const SE2& expected) {
  EXPECT_NEAR(pose.x, expected.x, 1e-9);
  EXPECT_NEAR(pose.y, expected.y, 1e-9);
  EXPECT_NEAR(backend::WrapAngle(pose.theta - expected.theta), 0.0, 1e-9);
}

TEST(ScanPoses, AreTheGivenOnesAtTheUpdates) {
  ScanPoses poses;
  std::vector<SE2> given;
  for (int i = 0; i < 30; ++i) {
    Add(i, {0.3 * i, 0.1 * i * i, 0.4 * i}, 1.0 + i % 3, i % 5 == 0, &poses);
    if (i % 5 == 0) given.push_back({-0.2 * i, 1.0 + i, -0.7 * i});
  }
  const backend::Trajectory trajectory = poses.Fill(given);
  ASSERT_EQ(trajectory.size(), 30u);
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(trajectory[i].stamp_s, 100.0 + i);
    if (i % 5 == 0) ExpectNear(trajectory[i].world_T_robot, given[i / 5]);
  }
}

TEST(ScanPoses, SpreadTheCorrectionInProportionToTheMotion) {
  // The odometry goes straight on for 4 m, in an odometry frame of its own; the next update finds
  // the robot 0.4 m to the left, 0.2 m short and turned by 0.1.
  const SE2 odom_T_world{10, 20, 1.0};
  ScanPoses poses;
  Add(0, odom_T_world, 0.0, true, &poses);
  Add(1, odom_T_world * SE2{1, 0, 0}, 1.0, false, &poses);
  Add(2, odom_T_world * SE2{1, 0, 0}, 0.0, false, &poses);
  Add(3, odom_T_world * SE2{3, 0, 0}, 2.0, false, &poses);
  Add(4, odom_T_world * SE2{4, 0, 0}, 1.0, true, &poses);
  const backend::Trajectory trajectory = poses.Fill({{0, 0, 0}, {3.8, 0.4, 0.1}});
  ASSERT_EQ(trajectory.size(), 5u);
  ExpectNear(trajectory[0].world_T_robot, {0, 0, 0});
  ExpectNear(trajectory[1].world_T_robot, {0.95, 0.1, 0.025});
  ExpectNear(trajectory[2].world_T_robot, {0.95, 0.1, 0.025});
  ExpectNear(trajectory[3].world_T_robot, {2.85, 0.3, 0.075});
  ExpectNear(trajectory[4].world_T_robot, {3.8, 0.4, 0.1});
}

TEST(ScanPoses, SpreadTheTurnTheShortWayRound) {
  ScanPoses poses;
  Add(0, {0, 0, 3.0}, 0.0, true, &poses);
  Add(1, {0, 0, 3.1}, 1.0, false, &poses);
  Add(2, {0, 0, 3.1}, 1.0, true, &poses);
  // Predicted 3.1, found 0.1 beyond pi.
  const double found = backend::WrapAngle(3.3);
  const backend::Trajectory trajectory = poses.Fill({{0, 0, 3.0}, {0, 0, found}});
  EXPECT_NEAR(backend::WrapAngle(trajectory[1].world_T_robot.theta - 3.2), 0.0, 1e-9);
}

TEST(ScanPoses, FollowTheOdometryAfterTheLastUpdate) {
  ScanPoses poses;
  Add(0, {5, 5, 0}, 0.0, true, &poses);
  Add(1, {6, 5, 0}, 1.0, false, &poses);
  Add(2, {7, 5, 0.5}, 1.0, false, &poses);
  const double quarter = std::acos(0.0);
  const backend::Trajectory trajectory = poses.Fill({{0, 0, quarter}});
  ExpectNear(trajectory[1].world_T_robot, {0, 1, quarter});
  ExpectNear(trajectory[2].world_T_robot, {0, 2, quarter + 0.5});
}

TEST(ScanPoses, ComeInTheOrderOfTheInput) {
  ScanPoses poses;
  for (const int index : {2, 0, 3, 1}) Add(index, {1.0 * index, 0, 0}, 1.0, index == 2, &poses);
  const backend::Trajectory trajectory = poses.Fill({{2, 0, 0}});
  ASSERT_EQ(trajectory.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(trajectory[i].stamp_s, 100.0 + i);
    ExpectNear(trajectory[i].world_T_robot, {1.0 * i, 0, 0});
  }
}

TEST(ScanPoses, AreFiniteWithoutAnyMotion) {
  ScanPoses poses;
  for (int i = 0; i < 5; ++i) Add(i, {1, 2, 3}, 0.0, i % 2 == 0, &poses);
  const backend::Trajectory trajectory = poses.Fill({{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}});
  ASSERT_EQ(trajectory.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    ExpectNear(trajectory[i].world_T_robot, {0.1 * (i / 2), 0, 0});
  }
}

TEST(ScanPosesDeathTest, EveryUpdateNeedsItsPose) {
  ScanPoses poses;
  Add(0, {}, 0.0, true, &poses);
  Add(1, {}, 0.0, false, &poses);
  EXPECT_DEATH(poses.Fill({}), "");
  EXPECT_DEATH(poses.Fill({{}, {}}), "");
}

TEST(ScanPoses, ThatLieBeforeAPieceAreNotCorrectedByIt) {
  ScanPoses poses;
  for (int i = 0; i < 8; ++i) Add(i, {1.0 * i, 0, 0}, 1.0, i == 0, &poses);
  poses.BeginPiece(2);
  Add(8, {8, 0, 0}, 1.0, true, &poses);
  const backend::Trajectory trajectory = poses.Fill({{0, 0, 0}, {50, 30, 0}, {53.2, 30, 0}});
  for (int i = 0; i < 5; ++i) ExpectNear(trajectory[i].world_T_robot, {1.0 * i, 0, 0});
  ExpectNear(trajectory[5].world_T_robot, {50, 30, 0});
  EXPECT_GT(trajectory[6].world_T_robot.x, 51.0);  // the correction within the piece is spread
  ExpectNear(trajectory[8].world_T_robot, {53.2, 30, 0});
}

}  // namespace
}  // namespace gmapping_spa::frontend
