// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/laser_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gmapping_spa::rosbag {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

class LaserFramesTest : public testing::Test {
 protected:
  void Set(const char* parent, const char* child, double x, const AngleAxisd& turn) {
    tree_.Set(parent, child, Eigen::Translation3d(x, 0.0, 0.0) * turn);
  }
  void Set(const char* parent, const char* child, double x) {
    Set(parent, child, x, AngleAxisd(0.0, Vector3d::UnitZ()));
  }
  Mounting MountedBy(const AngleAxisd& turn) {
    Set("base_link", "laser", 0.0, turn);
    return LaserFrames("base_link").Find(tree_, "laser").value();
  }

  TransformTree tree_;
};

TEST_F(LaserFramesTest, RobotsFrameIsThatOfTheFirstOdometryThatTellsOne) {
  Set("base_link", "laser", 0.25);
  LaserFrames frames("");
  frames.SetOdometryFrame("");
  EXPECT_FALSE(frames.Find(tree_, "laser"));
  frames.SetOdometryFrame("base_link");
  frames.SetOdometryFrame("wheel");
  EXPECT_EQ(frames.base_frame(), "base_link");
  EXPECT_EQ(frames.Find(tree_, "laser")->robot_T_frame.x, 0.25);
  EXPECT_FALSE(frames.Find(tree_, "camera"));
}

TEST_F(LaserFramesTest, FrameThatIsNamedGoesBeforeThatOfTheOdometry) {
  LaserFrames frames("/axle");
  frames.SetOdometryFrame("base_link");
  EXPECT_EQ(frames.base_frame(), "axle");
}

TEST_F(LaserFramesTest, ChainOfFixedAndMovingFramesIsThatOfTheLatestTransforms) {
  Set("turret", "laser", 0.5);  // children may come before their parents
  Set("base_link", "turret", 1.0, {0.5 * std::numbers::pi, Vector3d::UnitZ()});
  const LaserFrames frames("base_link");
  backend::SE2 pose = frames.Find(tree_, "laser")->robot_T_frame;
  EXPECT_NEAR(pose.x, 1.0, 1e-12);
  EXPECT_NEAR(pose.y, 0.5, 1e-12);
  EXPECT_NEAR(pose.theta, 0.5 * std::numbers::pi, 1e-12);
  Set("base_link", "turret", 1.0);
  pose = frames.Find(tree_, "laser")->robot_T_frame;
  EXPECT_NEAR(pose.x, 1.5, 1e-12);
  EXPECT_NEAR(pose.theta, 0.0, 1e-12);
}

TEST_F(LaserFramesTest, LaserIsUpsideDownHoweverItWasTurnedOver) {
  const Mounting rolled = MountedBy({std::numbers::pi, Vector3d::UnitX()});
  EXPECT_TRUE(rolled.upside_down);
  EXPECT_NEAR(rolled.robot_T_frame.theta, 0.0, 1e-12);
  const Mounting pitched = MountedBy({std::numbers::pi, Vector3d::UnitY()});
  EXPECT_TRUE(pitched.upside_down);
  EXPECT_NEAR(std::abs(pitched.robot_T_frame.theta), std::numbers::pi, 1e-12);
  EXPECT_NEAR(pitched.tilt_rad, 0.0, 1e-7);
  EXPECT_FALSE(MountedBy({std::numbers::pi, Vector3d::UnitZ()}).upside_down);
}

TEST_F(LaserFramesTest, TiltIsTheAngleBetweenThePlanesWhicheverSideIsUp) {
  const Mounting upright = MountedBy({0.3, Vector3d::UnitY()});
  EXPECT_NEAR(upright.tilt_rad, 0.3, 1e-12);
  EXPECT_FALSE(upright.upside_down);
  const Mounting turned_over = MountedBy({std::numbers::pi - 0.3, Vector3d::UnitX()});
  EXPECT_NEAR(turned_over.tilt_rad, 0.3, 1e-12);
  EXPECT_TRUE(turned_over.upside_down);
}

TEST_F(LaserFramesTest, AxisThatRoundingMadeTooLongIsNotTilted) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear()(2, 2) = std::nextafter(1.0, 2.0);
  tree_.Set("base_link", "laser", pose);
  EXPECT_EQ(LaserFrames("base_link").Find(tree_, "laser")->tilt_rad, 0.0);
}

TEST_F(LaserFramesTest, UsualFramesPassForTheRobotsWhereThisIsNotConnected) {
  LaserFrames frames("chassis");
  Set("base_footprint", "laser", 0.25);
  EXPECT_FALSE(frames.Find(tree_, "laser"));
  EXPECT_EQ(frames.FindOrAssume(tree_, "laser").base_frame, "base_footprint");
  Set("base_footprint", "base_link", 0.125);
  const Mounting mounting = frames.FindOrAssume(tree_, "laser");
  EXPECT_EQ(mounting.base_frame, "base_link");
  EXPECT_EQ(mounting.robot_T_frame.x, 0.125);
}

TEST_F(LaserFramesTest, LaserThatNothingConnectsIsAssumedToBeWhereTheRobotIs) {
  const LaserFrames frames("chassis");
  for (const char* frame : {"laser", "base_link", "base_footprint", ""}) {
    const Mounting mounting = frames.FindOrAssume(tree_, frame);
    EXPECT_EQ(mounting.base_frame, "") << frame;
    EXPECT_EQ(mounting.robot_T_frame, backend::SE2{}) << frame;
  }
}

}  // namespace
}  // namespace gmapping_spa::rosbag
