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

}  // namespace
}  // namespace gmapping_spa::apps
