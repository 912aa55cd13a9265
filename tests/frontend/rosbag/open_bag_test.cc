// SPDX-License-Identifier: BSD-3-Clause
// Bags of every kind, from the file to scans.
#include "frontend/rosbag/open_bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "tests/frontend/rosbag/small_bag.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::rosbag {
namespace {

using sensor::BeamStatus;
using ::testing::HasSubstr;

class EveryKindOfBag : public testing::TestWithParam<std::string> {
 protected:
  SmallBag Begin() { return SmallBag(folder_.Path("log"), GetParam()); }

  TemporaryFolder folder_;
};

TEST_P(EveryKindOfBag, HasScansWithOdometryAndMounting) {
  SmallBag bag = Begin();
  WriteDrive(&bag);
  const ReadBag read = ReadAll(bag.Finish());
  ASSERT_EQ(read.scans.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    const sensor::LaserScan& scan = read.scans[i];
    EXPECT_DOUBLE_EQ(scan.stamp_s, 10.5 + i);
    EXPECT_TRUE(scan.has_odometry);
    EXPECT_NEAR(scan.odom_T_robot.x, 0.5 * i + 0.25, 1e-9);
    EXPECT_NEAR(scan.odom_T_robot.theta, 0.1, 1e-9);
    EXPECT_NEAR(scan.robot_T_laser.x, 0.2, 1e-12);
    ASSERT_EQ(scan.beams.size(), 5u);
    EXPECT_NEAR(scan.beams[4].angle_rad, 1.0, 1e-6);
    EXPECT_NEAR(scan.beams[0].range_m, 1.0 + 0.25 * i, 1e-6);
    EXPECT_EQ(scan.beams[0].status, BeamStatus::kHit);
  }
  EXPECT_EQ(read.counts.at("scan_records"), 4);
  EXPECT_EQ(read.counts.at("odometry_records"), 5);
  for (const char* none : {"malformed_records", "laser_pose_assumed", "laser_pose_changes",
                           "unclosed_bag", "cut_off_bytes", "several_scan_topics"}) {
    EXPECT_EQ(read.counts.at(none), 0) << none;
  }
  EXPECT_EQ(read.report.base_frame, "base_link");
  EXPECT_EQ(read.report.odometry_from, "/odom");
  ASSERT_EQ(read.report.topics.size(), 3u);
  EXPECT_EQ(read.report.topics[1].messages, 5);
  EXPECT_EQ(read.report.topics[2].used_for, "scans");
}

TEST_P(EveryKindOfBag, IsReadInTheOrderOfTimeHoweverItWasWritten) {
  SmallBag bag = Begin();
  for (int i = 0; i < 8000; ++i) bag.Scan((100 + i) * kSecond_ns / 10);  // several chunks
  for (int i = 0; i < 8000; ++i) {
    bag.Odometry((100 + i) * kSecond_ns / 10, Planar(0.01 * i, 0.0, 0.0));
  }
  const ReadBag read = ReadAll(bag.Finish());
  ASSERT_EQ(read.scans.size(), 8000u);
  for (int i = 0; i < 8000; ++i) ASSERT_NEAR(read.scans[i].odom_T_robot.x, 0.01 * i, 1e-9) << i;
  EXPECT_EQ(read.counts.at("odometry_extrapolated"), 0);
}

TEST_P(EveryKindOfBag, WithoutScansSaysWhatItHolds) {
  SmallBag bag = Begin();
  bag.Odometry(kSecond_ns, Planar(0, 0, 0));
  const std::string path = bag.Finish();
  EXPECT_EQ(MessageOf([&] { ReadAll(path); }),
            path +
                ": no laser scans found (expected sensor_msgs/LaserScan or MultiEchoLaserScan, "
                "found '/odom' (nav_msgs/Odometry))");
}

TEST_P(EveryKindOfBag, MayHaveManyFiles) {
  const std::string folder = folder_.Path("bag");
  std::filesystem::create_directory(folder);
  for (int part = 0; part < 3; ++part) {
    SmallBag bag(folder + "/part_" + std::to_string(2 - part), GetParam());
    for (int i = 0; i < 2; ++i) {
      const std::int64_t stamp_ns = (1 + 2 * part + i) * kSecond_ns;
      bag.Odometry(stamp_ns, Planar(part, 0.0, 0.0));
      bag.Scan(stamp_ns);
    }
    bag.Finish();
  }
  const ReadBag all = ReadAll(folder);
  ASSERT_EQ(all.scans.size(), 6u);
  EXPECT_EQ(all.scans[4].odom_T_robot.x, 2.0);
  EXPECT_EQ(all.counts.at("out_of_order_scans"), 0);
  EXPECT_THAT(all.report.format, HasSubstr("3 files"));

  std::ofstream(folder + "/metadata.yaml")
      << "rosbag2_bagfile_information:\n  relative_file_paths:\n    - part_2\n    - part_9\n";
  const ReadBag listed = ReadAll(folder);
  EXPECT_EQ(listed.scans.size(), 2u);
  EXPECT_EQ(listed.counts.at("missing_files"), 1);
}

INSTANTIATE_TEST_SUITE_P(OpenBag, EveryKindOfBag,
                         testing::Values("bag", "packed.bag", "mcap", "packed.mcap", "db3"),
                         [](const auto& param_info) {
                           std::string name = param_info.param;
                           std::erase(name, '.');
                           return name;
                         });

class OpenBagTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  SmallBag bag_{folder_.Path("log"), "mcap"};
};

TEST_F(OpenBagTest, RangesMeanWhatRep117Says) {
  const float inf = std::numeric_limits<float>::infinity();
  ScanFields scan;
  scan.ranges_m = {1.0f, inf, -inf, std::nanf(""), 0.05f, 30.0f, 31.0f, 0.0f, -1.0f};
  scan.angle_increment_rad = 0.1f;
  bag_.Scan(kSecond_ns, scan);
  const ReadBag read = ReadAll(bag_.Finish());
  std::vector<BeamStatus> found;
  for (const sensor::Beam& beam : read.scans.at(0).beams) found.push_back(beam.status);
  const BeamStatus hit = BeamStatus::kHit, none = BeamStatus::kNoReturn;
  const BeamStatus invalid = BeamStatus::kInvalid;
  EXPECT_EQ(found, (std::vector<BeamStatus>{hit, none, invalid, invalid, invalid, none, none,
                                            invalid, invalid}));
}

TEST_F(OpenBagTest, UpsideDownLaserIsSeenFromAbove) {
  // Turned about its x axis by half a turn, then 0.5 rad to the left.
  bag_.Tf(kSecond_ns, "base_link", "laser",
          {0.1, 0.0, 0.3, std::cos(0.25), std::sin(0.25), 0.0, 0.0});
  bag_.Odometry(kSecond_ns, Planar(0, 0, 0));
  bag_.Scan(2 * kSecond_ns);
  const ReadBag read = ReadAll(bag_.Finish());
  EXPECT_NEAR(read.scans.at(0).robot_T_laser.theta, 0.5, 1e-12);
  EXPECT_NEAR(read.scans.at(0).beams.front().angle_rad, 1.0, 1e-6);
  EXPECT_NEAR(read.scans.at(0).beams.back().angle_rad, -1.0, 1e-6);
  EXPECT_TRUE(read.report.lasers.at(0).upside_down);
}

TEST_F(OpenBagTest, LaserPoseGoesThroughTheTreeAndMayComeLate) {
  bag_.Odometry(kSecond_ns, Planar(0, 0, 0), "base_footprint");
  bag_.Scan(2 * kSecond_ns);
  bag_.Tf(3 * kSecond_ns, "/base_footprint", "/base_link",
          Planar(0.0, 0.0, 0.5 * std::numbers::pi));
  bag_.Tf(4 * kSecond_ns, "base_link", "laser", Planar(0.3, 0.0, 0.0));
  const ReadBag read = ReadAll(bag_.Finish());
  EXPECT_NEAR(read.scans.at(0).robot_T_laser.y, 0.3, 1e-12);
  EXPECT_EQ(read.counts.at("laser_pose_assumed"), 0);
}

TEST_F(OpenBagTest, LaserWithoutATransformIsWhereTheRobotIsAndCounted) {
  bag_.Odometry(kSecond_ns, Planar(0, 0, 0));
  bag_.Tf(kSecond_ns, "base_link", "camera", Planar(0.3, 0.0, 0.0));
  for (int i = 2; i < 30; ++i) bag_.Scan(i * kSecond_ns);
  const ReadBag read = ReadAll(bag_.Finish());
  EXPECT_EQ(read.scans.at(0).robot_T_laser, backend::SE2{});
  EXPECT_EQ(read.counts.at("laser_pose_assumed"), 28);
  EXPECT_EQ(read.report.lasers.at(0).from, "assumed");
}

TEST_F(OpenBagTest, LaserPoseThatWasAssumedGivesWayToATransform) {
  bag_.Odometry(kSecond_ns, Planar(0, 0, 0));
  bag_.Tf(kSecond_ns, "base_link", "camera", Planar(0.3, 0.0, 0.0));
  for (int i = 2; i < 30; ++i) bag_.Scan(i * kSecond_ns);
  bag_.Tf(30 * kSecond_ns, "base_link", "laser", Planar(0.3, 0.0, 0.0));
  for (int i = 31; i < 40; ++i) bag_.Scan(i * kSecond_ns);
  const ReadBag read = ReadAll(bag_.Finish());
  EXPECT_NEAR(read.scans.back().robot_T_laser.x, 0.3, 1e-12);
  EXPECT_EQ(read.counts.at("laser_pose_assumed"), 28);
  EXPECT_EQ(read.report.lasers.size(), 2u);
}

TEST_F(OpenBagTest, OtherFrameOfTheRobotIsTakenAndCountedWhereTheOdometrysIsNotConnected) {
  bag_.Odometry(kSecond_ns, Planar(0, 0, 0), "base_footprint");
  bag_.Tf(kSecond_ns, "base_link", "laser", Planar(0.3, 0.0, 0.0));
  bag_.Scan(2 * kSecond_ns);
  const ReadBag read = ReadAll(bag_.Finish());
  EXPECT_NEAR(read.scans.at(0).robot_T_laser.x, 0.3, 1e-12);
  EXPECT_EQ(read.counts.at("laser_pose_other_base"), 1);
}

TEST_F(OpenBagTest, OdometryComesFromTfWhereThereIsNoTopic) {
  bag_.Tf(kSecond_ns, "base_link", "laser", Planar(0.3, 0.0, 0.0));
  for (int i = 1; i < 5; ++i) {
    bag_.Tf(i * kSecond_ns, "map", "odom", Planar(9.0, 0.0, 0.0), "/tf");
    bag_.Tf(i * kSecond_ns, "odom", "base_link", Planar(i, 0.0, 0.0), "/tf");
    bag_.Scan(i * kSecond_ns);
  }
  const ReadBag read = ReadAll(bag_.Finish());
  ASSERT_EQ(read.scans.size(), 4u);
  EXPECT_EQ(read.scans[2].odom_T_robot.x, 3.0);
  EXPECT_NEAR(read.scans[2].robot_T_laser.x, 0.3, 1e-12);
  EXPECT_EQ(read.report.odometry_from, "tf odom -> base_link");
}

TEST_F(OpenBagTest, BaseFrameMovesOdometryAndLaser) {
  bag_.Odometry(kSecond_ns, Planar(1.0, 0.0, 0.0), "base_footprint");
  bag_.Tf(kSecond_ns, "base_footprint", "axle", Planar(-0.2, 0.0, 0.0));
  bag_.Tf(kSecond_ns, "base_footprint", "laser", Planar(0.3, 0.0, 0.0));
  bag_.Scan(kSecond_ns);
  const ReadBag read = ReadAll(bag_.Finish(), {.base_frame = "axle"});
  EXPECT_NEAR(read.scans.at(0).robot_T_laser.x, 0.5, 1e-12);
  EXPECT_NEAR(read.scans.at(0).odom_T_robot.x, 0.8, 1e-12);
}

TEST_F(OpenBagTest, OfSeveralTopicsTheUsualOneIsTakenAndCounted) {
  bag_.Scan(kSecond_ns, {}, "/rear/scan");
  bag_.Scan(kSecond_ns, {.ranges_m = {7.0f, 7.0f}});
  const std::string path = bag_.Finish();
  const ReadBag read = ReadAll(path);
  EXPECT_EQ(read.scans.at(0).beams.size(), 2u);
  EXPECT_EQ(read.counts.at("several_scan_topics"), 2);
  EXPECT_EQ(ReadAll(path, {.scan_topic = "rear/scan"}).scans.at(0).beams.size(), 5u);
  EXPECT_EQ(MessageOf([&] { ReadAll(path, {.scan_topic = "/front"}); }),
            path +
                ": expected laser scans on the topic '/front', found them on '/rear/scan' (1), "
                "'/scan' (1)");
}

TEST_F(OpenBagTest, OfSeveralTopicsWithoutTheUsualOneOneMustBeNamed) {
  bag_.Scan(kSecond_ns, {}, "/front");
  bag_.Scan(kSecond_ns, {}, "/rear");
  const std::string path = bag_.Finish();
  EXPECT_EQ(MessageOf([&] { ReadAll(path); }),
            path +
                ": expected one topic of laser scans, found '/front' (1), '/rear' (1): "
                "--scan_topic names one");
}

TEST_F(OpenBagTest, SweepIsTheTimeFromTheFirstBeamToTheLast) {
  bag_.Scan(kSecond_ns, {.time_increment_s = 0.025f});
  bag_.Scan(2 * kSecond_ns, {.time_increment_s = 25.0f});
  const ReadBag read = ReadAll(bag_.Finish());
  EXPECT_NEAR(read.scans.at(0).sweep_s, 0.1, 1e-6);
  EXPECT_EQ(read.scans.at(1).sweep_s, 0.0);  // no laser takes 100 s
}

TEST_F(OpenBagTest, MessageWithoutAStampHasThatOfItsRecording) {
  bag_.Write("/scan", "sensor_msgs/LaserScan", 5 * kSecond_ns, ScanBytes(Encoding::kCdr, 0));
  const ReadBag read = ReadAll(bag_.Finish());
  EXPECT_EQ(read.scans.at(0).stamp_s, 5.0);
  EXPECT_EQ(read.counts.at("stamps_of_recording"), 1);
}

// As rosbag2 writes with the compression mode "message".
TEST_F(OpenBagTest, MessagesMayBePackedByThemselves) {
  const std::string message = ScanBytes(Encoding::kCdr, kSecond_ns);
  std::string packed(ZSTD_compressBound(message.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), message.data(), message.size(), 1));
  bag_.Write("/scan", "sensor_msgs/LaserScan", kSecond_ns, packed);
  bag_.Write("/scan", "sensor_msgs/LaserScan", 2 * kSecond_ns, packed.substr(0, 6));
  const ReadBag read = ReadAll(bag_.Finish());
  EXPECT_EQ(read.scans.at(0).beams.size(), 5u);
  EXPECT_EQ(read.counts.at("malformed_records"), 1);
}

TEST_F(OpenBagTest, PackedFileIsToBeUnpacked) {
  const std::string path = folder_.FileWith("log.db3.zstd", "\x28\xb5\x2f\xfd....");
  EXPECT_THAT(MessageOf([&] { ReadAll(path); }), HasSubstr("unpack it first"));
}

}  // namespace
}  // namespace gmapping_spa::rosbag
