// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/live_reader.h"

#include <gflags/gflags.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>

#include "tests/frontend/rosbag/small_bag.h"
#include "tests/message_of.h"

namespace gmapping_spa::ros {
namespace {

using rosbag::Encoding;
using rosbag::kSecond_ns;
using rosbag::Planar;

class LiveReaderTest : public testing::Test {
 protected:
  void GiveTf(int time_s, const char* parent, const char* child, double x) {
    const std::int64_t time_ns = time_s * kSecond_ns;
    source_.Give(LiveSource::kTf,
                 rosbag::TfBytes(Encoding::kRos1, time_ns, parent, child, Planar(x, 0, 0)),
                 time_ns);
  }
  void GiveScan(int time_s) {
    const std::int64_t time_ns = time_s * kSecond_ns;
    source_.Give(LiveSource::kScan, rosbag::ScanBytes(Encoding::kRos1, time_ns), time_ns);
  }
  // Drives at 0.5 m/s, a scan every other second, from 10 s to 20 s.
  void Drive() {
    GiveTf(10, "base_link", "laser", 0.25);
    for (int time_s = 10; time_s <= 20; time_s += 2) {
      GiveTf(time_s - 1, "odom", "base_link", 0.5 * (time_s - 1));
      GiveTf(time_s + 1, "odom", "base_link", 0.5 * (time_s + 1));
      GiveScan(time_s);
    }
  }
  void Close() { source_.Close(std::chrono::hours(1)); }

  gflags::FlagSaver flags_;
  LiveSource source_{Encoding::kRos1, 1 << 20};
};

TEST_F(LiveReaderTest, GivesAScanWithItsOdometryAndMountingWhileTheRobotDrives) {
  Drive();
  const auto reader = MakeLiveReader(&source_);
  auto first = std::async(std::launch::async, [&] { return reader->Next(); });
  // A reader of bags would hold back 200 scans.
  EXPECT_EQ(first.wait_for(std::chrono::seconds(20)), std::future_status::ready);
  Close();
  const std::optional<sensor::LaserScan> scan = first.get();
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->stamp_s, 10.0);
  EXPECT_NEAR(scan->odom_T_robot.x, 5.0, 1e-9);
  EXPECT_NEAR(scan->robot_T_laser.x, 0.25, 1e-9);
}

TEST_F(LiveReaderTest, GivesWhatIsLeftWhenTheSourceIsClosed) {
  Drive();
  Close();
  const auto reader = MakeLiveReader(&source_);
  int scans = 0;
  while (reader->Next()) ++scans;
  EXPECT_EQ(scans, 6);
  EXPECT_EQ(reader->counts().at("odometry_records"), 12);
  EXPECT_EQ(reader->counts().at("laser_pose_assumed"), 0);
}

TEST_F(LiveReaderTest, ReadsAsTheFlagsSay) {
  gflags::SetCommandLineOption("base_frame", "axle");
  GiveTf(10, "base_link", "axle", 0.5);
  Drive();
  Close();
  const auto scan = MakeLiveReader(&source_)->Next();
  EXPECT_NEAR(scan->robot_T_laser.x, -0.25, 1e-9);
  EXPECT_NEAR(scan->odom_T_robot.x, 5.5, 1e-9);
}

TEST_F(LiveReaderTest, EndOfASourceWithoutScansIsAnError) {
  GiveTf(10, "odom", "base_link", 0.0);
  Close();
  EXPECT_EQ(MessageOf([&] { MakeLiveReader(&source_)->Next(); }),
            "live: no laser scans found (0 malformed messages)");
}

}  // namespace
}  // namespace gmapping_spa::ros
