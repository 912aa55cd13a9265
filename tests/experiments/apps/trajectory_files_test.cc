// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/trajectory_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::SizeIs;
using ::testing::ThrowsMessage;

class TrajectoryFiles : public ::testing::Test {
 protected:
  TrajectoryFile Read(const std::string& name, const std::string& text) {
    return ReadTrajectoryFile(folder_.FileWith(name, text));
  }

  TemporaryFolder folder_;
};

TEST_F(TrajectoryFiles, ReadsPosesBehindAByteOrderMarkAndBeforeComments) {
  const TrajectoryFile file = Read("a.tum",
                                   "\xef\xbb\xbf"
                                   "# stamp x y z q\n1 2 3 0 0 0 0 1 # start\n2 2 3 0 0 0 0 1\n");
  EXPECT_EQ(file.path, folder_.Path("a.tum"));
  ASSERT_THAT(file.poses, SizeIs(2));
  EXPECT_EQ(file.poses[0].world_T_robot.y, 3.0);
}

TEST_F(TrajectoryFiles, AFileWithoutPosesIsNamed) {
  for (const char* text : {"", "\n", "# nothing\n"}) {
    EXPECT_THAT([&] { Read("empty.tum", text); },
                ThrowsMessage<std::runtime_error>(folder_.Path("empty.tum") + ": holds no poses"));
  }
}

TEST_F(TrajectoryFiles, PosesBelongTogetherByTheirStamps) {
  const TrajectoryFile truth = Read("t.tum", "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n");
  const TrajectoryFile estimate = Read("e.tum", "2.005 5 0 0 0 0 0 1\n9 0 0 0 0 0 0 1\n");
  EXPECT_THAT(AssociateFiles(truth, estimate, 0.01), SizeIs(1));
}

TEST_F(TrajectoryFiles, StampsOfBothFilesAreToldWhereNoneFits) {
  const TrajectoryFile truth = Read("t.tum", "2 1 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n");
  const TrajectoryFile estimate = Read("e.tum", "1000000000 5 0 0 0 0 0 1\n");
  EXPECT_THAT(
      [&] { AssociateFiles(truth, estimate, 0.01); },
      ThrowsMessage<std::runtime_error>(
          "no pose could be associated by its stamp within 0.01 s: " + folder_.Path("t.tum") +
          " has stamps from 1.000 to 2.000, " + folder_.Path("e.tum") +
          " has stamps from 1000000000.000 to 1000000000.000 (expected seconds of one "
          "clock)"));
}

TEST_F(TrajectoryFiles, TwelveColumnsAreKitti) {
  const TrajectoryFile file = ReadTumOrKittiFile(
      folder_.FileWith("a.txt", "# pose\n1 0 0 5 0 1 0 6 0 0 1 0\n1 0 0 7 0 1 0 6 0 0 1 0\n"));
  EXPECT_FALSE(file.has_stamps);
  ASSERT_THAT(file.poses, SizeIs(2));
  EXPECT_EQ(file.poses[1].world_T_robot.x, 7.0);
  EXPECT_TRUE(ReadTumOrKittiFile(folder_.FileWith("b.tum", "1 2 3 0 0 0 0 1\n")).has_stamps);
  EXPECT_THAT([&] { ReadTumOrKittiFile(folder_.FileWith("c", "1 2\n")); },
              ThrowsMessage<std::runtime_error>(
                  folder_.Path("c") + ":1: expected 8 columns (stamp x y z qx qy qz qw), found 2"));
}

TEST_F(TrajectoryFiles, PosesWithoutStampsBelongTogetherByTheirNumber) {
  TrajectoryFile truth{"t.txt", {{0, {1, 0, 0}}, {1, {2, 0, 0}}}, false};
  TrajectoryFile estimate{"e.txt", {{0, {3, 0, 0}}, {1, {4, 0, 0}}}, false};
  const auto pairs = AssociateFiles(truth, estimate, 0.01);
  ASSERT_THAT(pairs, SizeIs(2));
  EXPECT_EQ(pairs[1].estimate_T_robot.x, 4.0);

  estimate.poses.pop_back();
  EXPECT_THAT([&] { AssociateFiles(truth, estimate, 0.01); },
              ThrowsMessage<std::runtime_error>("e.txt: expected as many poses as in t.txt, 2, as "
                                                "they have no stamps, found 1"));
  truth.has_stamps = true;
  EXPECT_THAT([&] { AssociateFiles(truth, estimate, 0.01); },
              ThrowsMessage<std::runtime_error>("e.txt: has no stamps (KITTI), and t.txt has "
                                                "(TUM): expected two files of one format"));
}

}  // namespace
}  // namespace gmapping_spa::apps
