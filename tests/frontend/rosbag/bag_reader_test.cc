// SPDX-License-Identifier: BSD-3-Clause
// What bags of unknown robots hold: frames and stamps that are missing, move or disagree.
#include "frontend/rosbag/bag_reader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/frontend/rosbag/small_bag.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::rosbag {
namespace {

class BagReaderTest : public testing::Test {
 protected:
  ReadBag Read(const sensor::LogOptions& options = {}) { return ReadAll(bag_.Finish(), options); }
  // A scan of one beam 1 rad to the left.
  void Scan(int time_s, const char* frame = "laser") {
    bag_.Scan(time_s * kSecond_ns,
              {.frame = frame, .angle_min_rad = 1.0f, .ranges_m = std::vector<float>{2.0f}});
  }
  void Odometry(int time_s, double x, const char* child = "base_link") {
    bag_.Odometry(time_s * kSecond_ns, Planar(x, 0.0, 0.0), child);
  }
  void Tf(int time_s, const char* parent, const char* child, const PoseNumbers& pose) {
    bag_.Tf(time_s * kSecond_ns, parent, child, pose, "/tf");
  }

  TemporaryFolder folder_;
  SmallBag bag_{folder_.Path("log"), "mcap"};
};

TEST_F(BagReaderTest, OdometryOfATopicGoesBeforeTfUnlessTheTopicOfTfIsNamed) {
  for (const int time_s : {1, 2}) {
    Odometry(time_s, 3.0);
    Tf(time_s, "odom", "base_link", Planar(7.0, 0.0, 0.0));
    Scan(time_s);
  }
  const std::string path = bag_.Finish();
  const ReadBag of_topic = ReadAll(path), of_tf = ReadAll(path, {.odometry_topic = "/tf"});
  EXPECT_EQ(of_topic.scans.at(0).odom_T_robot.x, 3.0);
  EXPECT_EQ(of_topic.report.odometry_from, "/odom");
  EXPECT_EQ(of_tf.scans.at(0).odom_T_robot.x, 7.0);
  EXPECT_EQ(of_tf.counts.at("odometry_records"), 2);
}

TEST_F(BagReaderTest, OdometryWithoutAStampHasThatOfItsRecording) {
  for (const int time_s : {10, 12}) {
    bag_.Write("/tf", "tf2_msgs/TFMessage", time_s * kSecond_ns,
               TfBytes(bag_.encoding(), 0, "odom", "base_link", Planar(time_s, 0.0, 0.0)));
  }
  Scan(11);
  const ReadBag read = Read();
  EXPECT_NEAR(read.scans.at(0).odom_T_robot.x, 11.0, 1e-9);
  EXPECT_EQ(read.counts.at("stamps_of_recording"), 2);
}

TEST_F(BagReaderTest, OdometryThatDoesNotNameItsFrameIsThatOfTheUsualOne) {
  Odometry(1, 0.0, "");
  Tf(1, "base_link", "laser", Planar(0.5, 0.0, 0.0));
  Scan(2);
  const ReadBag read = Read();
  EXPECT_NEAR(read.scans.at(0).robot_T_laser.x, 0.5, 1e-9);
  EXPECT_EQ(read.report.base_frame, "base_link");
  EXPECT_EQ(read.counts.at("laser_pose_assumed"), 0);
}

TEST_F(BagReaderTest, LasersThatShareATopicHaveAMountingEach) {
  Odometry(1, 0.0);
  Tf(1, "base_link", "front", Planar(0.5, 0.0, 0.0));
  Tf(1, "base_link", "rear", Planar(-0.5, 0.0, 0.0));
  for (int time_s = 2; time_s < 6; ++time_s) Scan(time_s, time_s % 2 == 0 ? "front" : "rear");
  const ReadBag read = Read();
  EXPECT_NEAR(read.scans.at(2).robot_T_laser.x, 0.5, 1e-9);
  EXPECT_NEAR(read.scans.at(3).robot_T_laser.x, -0.5, 1e-9);
  EXPECT_EQ(read.report.lasers.size(), 2u);
  EXPECT_EQ(read.counts.at("laser_pose_changes"), 0);
}

TEST_F(BagReaderTest, LaserThatMovesStaysWhereItWasFirstAndIsCounted) {
  Odometry(1, 0.0);
  for (int i = 0; i < 4; ++i) {
    Tf(2 + i, "base_link", "turret", Planar(0.0, 0.0, 0.006 * i));
    Tf(2 + i, "turret", "laser", Planar(0.5, 0.0, 0.0));
    Scan(2 + i);
  }
  const ReadBag read = Read();
  EXPECT_EQ(read.scans.at(3).robot_T_laser.theta, read.scans.at(0).robot_T_laser.theta);
  EXPECT_EQ(read.counts.at("laser_pose_changes"), 2) << "0.012 and 0.018 rad, beyond 0.01";
  EXPECT_EQ(read.report.lasers.size(), 1u);
}

TEST_F(BagReaderTest, TiltedLaserIsCountedAndTakenAsLevel) {
  Odometry(1, 0.0);
  Tf(1, "base_link", "laser", {0.5, 0.0, 1.0, 0.0, std::sin(0.075), 0.0, std::cos(0.075)});
  Scan(2);
  const ReadBag read = Read();
  EXPECT_EQ(read.counts.at("laser_tilted"), 1);
  EXPECT_NEAR(read.report.lasers.at(0).tilt_rad, 0.15, 1e-9);
  EXPECT_NEAR(read.scans.at(0).beams.at(0).range_m, 2.0, 1e-9);
}

TEST_F(BagReaderTest, FlippedLaserThatTfTurnsOverAsWellIsUpright) {
  Odometry(1, 0.0);
  Tf(1, "base_link", "laser", {0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0});
  Scan(2);
  const std::string path = bag_.Finish();
  EXPECT_NEAR(ReadAll(path).scans.at(0).beams.at(0).angle_rad, -1.0, 1e-9);
  EXPECT_NEAR(ReadAll(path, {.flipped = true}).scans.at(0).beams.at(0).angle_rad, 1.0, 1e-9);
}

TEST_F(BagReaderTest, PoseOfTheOptionsReplacesAllThatTfSaysOfTheLaser) {
  Odometry(1, 0.0);
  Tf(1, "base_link", "laser", {0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0});
  Scan(2);
  const ReadBag read = Read({.robot_T_laser = backend::SE2{0.25, 0.0, 0.0}});
  EXPECT_EQ(read.scans.at(0).robot_T_laser.x, 0.25);
  EXPECT_NEAR(read.scans.at(0).beams.at(0).angle_rad, 1.0, 1e-9) << "not upside down either";
  ASSERT_EQ(read.report.lasers.size(), 1u);
  EXPECT_EQ(read.report.lasers[0].from, "--laser_pose");
}

}  // namespace
}  // namespace gmapping_spa::rosbag
