// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/slam_node_core.h"

#include <gflags/gflags.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "backend/se2.h"
#include "frontend/session/session_file.h"
#include "tests/frontend/rosbag/small_bag.h"
#include "tests/frontend/synthetic_room.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::ros {
namespace {

using backend::SE2;
using rosbag::Encoding;
using testing::Contains;
using testing::HasSubstr;

constexpr std::int64_t kStart_ns = 1000 * rosbag::kSecond_ns;

// x 5 m, y 6 m, heading 0.5 rad.
const SpatialPose kSomewhere{5.0, 6.0, 0.0, 0.0, 0.0, std::sin(0.25), std::cos(0.25)};

class Listener : public NodeOutput {
 public:
  void Say(Severity severity, const std::string& line) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (severity != Severity::kInfo) lines_.push_back(line);
  }
  void Show(const Snapshot& snapshot) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    snapshots_.push_back(snapshot);
  }
  std::vector<std::string> lines() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return lines_;
  }
  std::vector<Snapshot> snapshots() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return snapshots_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
  std::vector<Snapshot> snapshots_;
};

// A robot in a room, ten scans a second, at 0.2 m/s; its odometry begins somewhere.
class SlamNodeCoreTest : public testing::Test {
 protected:
  SlamNodeCoreTest() {
    gflags::SetCommandLineOption("base_frame", "base_link");
    gflags::SetCommandLineOption("odom_frame", "odom");
    gflags::SetCommandLineOption("reorder_window_s", "0.5");
    options_.map_update_interval_s = 1.0;
  }

  static std::int64_t Time_ns(int number) { return kStart_ns + number * rosbag::kSecond_ns / 10; }
  static SE2 RoomPose(int number) { return {0.02 * number, 0.0, 0.0}; }

  void Begin() {
    core_ = MakeSlamNodeCore(options_, Serialization::kRos1, &listener_);
    core_->TakeTf(rosbag::TfBytes(Encoding::kRos1, kStart_ns, "base_link", "laser",
                                  rosbag::Planar(0.1, 0.0, 0.0)),
                  kStart_ns);
  }

  void Give(int number) {
    const SE2 odom_T_robot = odom_T_start_ * RoomPose(number);
    core_->TakeTf(
        rosbag::TfBytes(Encoding::kRos1, Time_ns(number), "odom", "base_link",
                        rosbag::Planar(odom_T_robot.x, odom_T_robot.y, odom_T_robot.theta)),
        Time_ns(number));
    rosbag::ScanFields fields;
    fields.angle_min_rad = static_cast<float>(-std::numbers::pi / 2.0);
    fields.angle_increment_rad = static_cast<float>(std::numbers::pi / 180.0);
    fields.ranges_m.clear();
    const synthetic::Laser laser{.robot_T_laser = {0.1, 0.0, 0.0}};
    for (const sensor::Beam& beam :
         synthetic::Scan(synthetic::Room(), RoomPose(number), laser).beams) {
      fields.ranges_m.push_back(static_cast<float>(beam.range_m));
    }
    core_->TakeScan(rosbag::ScanBytes(Encoding::kRos1, Time_ns(number), fields), Time_ns(number));
  }

  void Drive(int scans) {
    Begin();
    for (int i = 0; i < scans; ++i) Give(i);
  }

  SE2 MapTOdom() const {
    const PlanarPose pose = core_->map_T_odom().value();
    return {pose.x_m, pose.y_m, pose.heading_rad};
  }

  // False after ten seconds.
  static bool WaitUntil(const std::function<bool()>& is_so) {
    for (int i = 0; i < 1000 && !is_so(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return is_so();
  }

  SE2 odom_T_start_{3.0, -1.0, 0.7};
  NodeOptions options_;
  Listener listener_;
  std::unique_ptr<SlamNodeCore> core_;
};

TEST_F(SlamNodeCoreTest, UsesEveryScanAndShowsTheMap) {
  Drive(60);
  core_->Finish();
  const ScanCounts counts = core_->counts();
  EXPECT_EQ(counts.received, 60);
  EXPECT_EQ(counts.used, 60);
  EXPECT_EQ(counts.waiting, 0);
  ASSERT_GE(listener_.snapshots().size(), 2u);
  const Snapshot last = listener_.snapshots().back();
  EXPECT_GT(std::ranges::count(last.cells, 100), 100);
  EXPECT_GE(last.map_T_nodes.size(), 2u);
  EXPECT_GE(last.entropy, 0.0);
  EXPECT_THAT(listener_.lines(), testing::IsEmpty());
}

TEST_F(SlamNodeCoreTest, TellsWhereTheOdometryLiesInTheMap) {
  Begin();
  EXPECT_FALSE(core_->map_T_odom());
  for (int i = 0; i < 60; ++i) Give(i);
  core_->Finish();
  ASSERT_TRUE(core_->map_T_odom());
  // The map frame is where the robot began.
  const SE2 difference = Between(Inverse(odom_T_start_), MapTOdom());
  EXPECT_LT(difference.translation().norm(), 0.03);
  EXPECT_LT(std::abs(difference.theta), 0.01);
}

TEST_F(SlamNodeCoreTest, BeginsAtAPoseThatIsToldBeforeTheFirstScan) {
  Begin();
  core_->SetStartPose("map", kSomewhere);
  EXPECT_THAT(listener_.lines(), Contains(HasSubstr("has a heading")));
  for (int i = 0; i < 30; ++i) Give(i);
  core_->Finish();
  const SE2 map_T_start = MapTOdom() * odom_T_start_;
  EXPECT_NEAR(map_T_start.x, 5.0, 0.03);
  EXPECT_NEAR(map_T_start.y, 6.0, 0.03);
  EXPECT_NEAR(map_T_start.theta, 0.5, 0.01);
  EXPECT_NEAR(listener_.snapshots().front().map_T_cells.heading_rad, 0.5, 1e-12);
}

TEST_F(SlamNodeCoreTest, RefusesAStartPoseWithAReason) {
  Drive(30);
  ASSERT_TRUE(WaitUntil([&] { return core_->counts().used > 0; }));
  core_->SetStartPose("map", kSomewhere);
  EXPECT_THAT(listener_.lines(), Contains(HasSubstr("the first scan has fixed the map frame")));
}

TEST_F(SlamNodeCoreTest, RefusesAStartPoseInAnotherFrame) {
  Begin();
  core_->SetStartPose("odom", {});
  EXPECT_THAT(listener_.lines(),
              Contains(HasSubstr("expected one in the frame 'map', found 'odom'")));
}

TEST_F(SlamNodeCoreTest, CountsScansThatItLeavesOutAsItIsTold) {
  options_.throttle_scans = 3;
  Drive(30);
  core_->Finish();
  EXPECT_EQ(core_->counts().throttled, 20);
  EXPECT_EQ(core_->counts().used, 10);
  EXPECT_THAT(listener_.lines(), testing::IsEmpty());
}

TEST_F(SlamNodeCoreTest, CountsAndSaysWhatItHasNoRoomFor) {
  options_.queue_limit_mb = 0.001;  // a scan has 0.8 kB
  Drive(200);
  core_->Finish();
  const ScanCounts counts = core_->counts();
  EXPECT_GT(counts.refused, 0);
  EXPECT_EQ(counts.received, counts.refused + counts.used);
  EXPECT_THAT(listener_.lines(), Contains(HasSubstr("does not keep up: scans are left out")));
  EXPECT_THAT(listener_.lines(), Contains(HasSubstr("not all scans are in the map")));
}

TEST_F(SlamNodeCoreTest, CountsAndSaysWhatDidNotGetHere) {
  Drive(3);
  core_->CountLost(2);
  core_->CountLost(1);
  EXPECT_EQ(core_->counts().lost, 3);
  EXPECT_EQ(listener_.lines().size(), 1u);
}

TEST_F(SlamNodeCoreTest, TakesNoMoreAfterTheClockWentBack) {
  Drive(30);
  Give(0);
  Give(1);
  core_->Finish();
  EXPECT_EQ(core_->counts().after_time_jump, 2);
  EXPECT_EQ(core_->counts().used, 30);
  EXPECT_THAT(listener_.lines(), Contains(HasSubstr("the clock went back by 2.9")));
}

TEST_F(SlamNodeCoreTest, FailsAfterTheClockWentBackWhereItShall) {
  options_.exit_on_time_jump = true;
  Drive(30);
  EXPECT_FALSE(core_->failed());
  Give(0);
  EXPECT_TRUE(core_->failed());
  EXPECT_THAT(MessageOf([&] { core_->Finish(); }), HasSubstr("the clock went back"));
}

TEST_F(SlamNodeCoreTest, SaysThatNoTransformTellsWhereTheLaserIs) {
  core_ = MakeSlamNodeCore(options_, Serialization::kRos1, &listener_);
  for (int i = 0; i < 10; ++i) Give(i);
  core_->Finish();
  EXPECT_EQ(core_->counts().used, 10);
  EXPECT_THAT(listener_.lines(), Contains(HasSubstr("laser_pose_assumed")));
}

TEST_F(SlamNodeCoreTest, EndsBeforeTheFirstScanWithoutAnError) {
  Begin();
  core_->Finish();
  EXPECT_FALSE(core_->failed());
}

TEST_F(SlamNodeCoreTest, SavesASessionWhereItIsTold) {
  const TemporaryFolder folder;
  Begin();
  EXPECT_THAT(MessageOf([&] { core_->SaveSession(); }), HasSubstr("~save_session: expected"));
  gflags::SetCommandLineOption("save_session", folder.Path("robot.session").c_str());
  Begin();
  EXPECT_EQ(MessageOf([&] { core_->SaveSession(); }), "there was no scan yet");
  for (int i = 0; i < 30; ++i) Give(i);
  ASSERT_TRUE(WaitUntil([&] { return core_->counts().used > 10; }));
  core_->SaveSession();
  EXPECT_TRUE(std::filesystem::exists(folder.Path("robot.session")));
  core_->Finish();
  std::ifstream file(folder.Path("robot.session"), std::ios::binary);
  EXPECT_EQ(session::ReadSession(&file, "session").info.scans, 30);
  gflags::SetCommandLineOption("save_session", "");
}

TEST_F(SlamNodeCoreTest, MakesTheMinimumScoreAMeanOverTheBeams) {
  options_.minimum_score = 18.1;
  Drive(10);
  core_->Finish();
  std::string value;
  gflags::GetCommandLineOption("match_min_score", &value);
  EXPECT_NEAR(std::stod(value), 0.1, 1e-6);
}

}  // namespace
}  // namespace gmapping_spa::ros
