// SPDX-License-Identifier: BSD-3-Clause
// A node that goes on in the map of another run.
#include <gflags/gflags.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "backend/se2.h"
#include "experiments/ros/slam_node_core.h"
#include "tests/experiments/ros/driven_node.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::ros {
namespace {

using backend::SE2;
using testing::Contains;
using testing::HasSubstr;

class OldMapTest : public DrivenNode {
 protected:
  // That of 100 scans; the next node goes on in it, and its odometry begins elsewhere.
  void MakeOldMap() {
    gflags::SetCommandLineOption("save_session", folder_.Path("robot.session").c_str());
    Drive(100);
    // The last ones wait for their odometry: Finish gives them the time for a few, not for all.
    ASSERT_TRUE(WaitUntil([&] { return core_->counts().used > 70; }));
    core_->Finish();
    core_.reset();
    gflags::SetCommandLineOption("save_session", "");
    gflags::SetCommandLineOption("map_session", folder_.Path("robot.session").c_str());
    odom_T_start_ = {-7.0, 2.0, 2.5};
  }

  const TemporaryFolder folder_;
};

TEST_F(OldMapTest, TellsThePoseOfTheRobotOnceItIsFoundInIt) {
  MakeOldMap();
  Begin();
  EXPECT_EQ(core_->old_map(), OldMap::kSearched);
  int told = 0;
  for (int i = 20; i < 200; ++i) {
    Give(i);
    // Those that are younger wait for their odometry.
    ASSERT_TRUE(WaitUntil([&] { return core_->counts().used > i - 30; }));
    if (!core_->map_T_odom()) continue;
    EXPECT_EQ(core_->old_map(), OldMap::kFound);
    ++told;
    // The map frame is where the robot began in the run before.
    const SE2 difference = Between(Inverse(odom_T_start_), MapTOdom());
    EXPECT_LT(difference.translation().norm(), 0.1);
    EXPECT_LT(std::abs(difference.theta), 0.02);
  }
  EXPECT_GT(told, 50);
  EXPECT_LT(told, 170);
  core_->Finish();
  EXPECT_THAT(listener_.lines(), testing::IsEmpty());
}

TEST_F(OldMapTest, IsShownAsItIsWhileTheRobotIsLocalizedInIt) {
  MakeOldMap();
  gflags::SetCommandLineOption("localize", "true");
  Begin();
  const std::size_t before = listener_.snapshots().size();
  for (int i = 20; i < 200; ++i) Give(i);
  ASSERT_TRUE(WaitUntil([&] { return core_->counts().used > 150; }));
  core_->Finish();
  EXPECT_EQ(core_->old_map(), OldMap::kFound);
  const std::vector<Snapshot> snapshots = listener_.snapshots();
  ASSERT_GT(snapshots.size(), before + 2);
  for (const Snapshot& snapshot : snapshots) {
    if (&snapshot < &snapshots[before]) continue;
    EXPECT_TRUE(snapshot.cells == snapshots[before].cells);
  }
  EXPECT_GT(snapshots.back().map_T_nodes.size(), snapshots[before].map_T_nodes.size());
}

TEST_F(OldMapTest, IsShownBeforeTheFirstScan) {
  MakeOldMap();
  const std::size_t before = listener_.snapshots().size();
  Begin();
  ASSERT_TRUE(WaitUntil([&] { return listener_.snapshots().size() > before; }));
  EXPECT_GT(std::ranges::count(listener_.snapshots().back().cells, 100), 100);
}

TEST_F(OldMapTest, IsNeededToLocalize) {
  gflags::SetCommandLineOption("localize", "true");
  EXPECT_THAT(MessageOf([&] { Begin(); }), HasSubstr("--localize needs --map_session=FILE"));
}

TEST_F(OldMapTest, TakesNoStartPose) {
  MakeOldMap();
  Begin();
  core_->SetStartPose("map", kSomewhere);
  EXPECT_THAT(listener_.lines(), Contains(HasSubstr("looked for in all of the map")));
}

}  // namespace
}  // namespace gmapping_spa::ros
