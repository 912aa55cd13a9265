// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/slam_node_core.h"

#include <gflags/gflags.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "backend/se2.h"
#include "frontend/session/session_file.h"
#include "tests/experiments/ros/driven_node.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::ros {
namespace {

using backend::SE2;
using testing::Contains;
using testing::HasSubstr;
using SlamNodeCoreTest = DrivenNode;

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
}

TEST_F(SlamNodeCoreTest, RefusesAFolderForResultsThatCannotBeWrittenBeforeTheRobotDrives) {
  gflags::SetCommandLineOption("output_dir", "/proc/x");
  EXPECT_THAT(MessageOf([&] { Begin(); }), HasSubstr("cannot make the folder '/proc/x'"));
}

TEST_F(SlamNodeCoreTest, TellsForHowLongNoScanHasCome) {
  Drive(3);
  EXPECT_LT(core_->counts().silent_s, 5.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_GE(core_->counts().silent_s, 0.05);
}

TEST_F(SlamNodeCoreTest, RefusesToGoOnWithARun) {
  gflags::SetCommandLineOption("resume", "robot.session");
  EXPECT_THAT(MessageOf([&] { Begin(); }), HasSubstr("--resume: expected none"));
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
