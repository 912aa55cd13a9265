// SPDX-License-Identifier: BSD-3-Clause
// Sessions of gmapping_spa: going on with them, and those that are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "backend/counter_random.h"
#include "tests/built_back_ends.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class SessionTour : public GmappingSpaTour {
 protected:
  // The begin of the log.
  std::string PartOfLog(double part) const {
    const std::string log = Contents(Log());
    const auto at = static_cast<std::size_t>(part * static_cast<double>(log.size()));
    return folder_.FileWith("part.clf", log.substr(0, log.find('\n', at) + 1));
  }

  // Writes the session of a part of the log; returns what was said.
  std::string SavePart(double part, std::vector<std::string> flags = {}) const {
    flags.push_back("--log=" + PartOfLog(part));
    flags.push_back("--save_session=" + session_);
    const CommandResult result = RunCommand(Command(folder_.Path("part"), flags));
    EXPECT_EQ(result.status, 0) << result.err;
    return result.err;
  }

  CommandResult Resume(std::vector<std::string> flags = {}) const {
    flags.push_back("--resume=" + session_);
    return RunCommand(Command(out_, flags));
  }

  void ExpectRefused(const std::vector<std::string>& flags, const std::string& why) const {
    const CommandResult result = Resume(flags);
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.err, StartsWith("gmapping_spa: error: " + session_ + ": expected "));
    EXPECT_THAT(result.err, HasSubstr(why));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(out_));
  }

  const std::string out_ = folder_.Path("out"), session_ = folder_.Path("s.session");
};

class GrownLog : public SessionTour, public ::testing::WithParamInterface<std::string> {};

// Bytes that a session of half of the log ends with.
TEST_P(GrownLog, GoesOnToTheBytesOfTheWholeLog) {
  const std::vector<std::string> flags = {GetParam()};
  const std::string whole = folder_.Path("whole");
  Run(whole, flags);
  SavePart(0.6, flags);
  const CommandResult result = Resume({GetParam(), "--threads=2"});
  ASSERT_EQ(result.status, 0) << result.err;
  ExpectSameResult(whole, out_);
}

std::vector<std::string> FlagsOfGrownLogs() {
  std::vector<std::string> flags = {"--optimize_every=3", "--graph_thread=inline",
                                    "--loss=truncated", "--odometry=lidar_only"};
  for (const char* backend : Built({"ceres", "none"})) {
    flags.push_back(std::string("--backend=") + backend);
  }
  return flags;
}

INSTANTIATE_TEST_SUITE_P(Sessions, GrownLog, ::testing::ValuesIn(FlagsOfGrownLogs()));

TEST_F(SessionTour, OtherFlagsAreRefusedByName) {
  SavePart(0.2);
  ExpectRefused({"--particles=4"}, "--particles=5, found --particles=4");
}

TEST_F(SessionTour, AnotherLogIsRefusedAtItsFirstScanThatDiffers) {
  SavePart(0.3);
  ExpectRefused({"--log=" + PartOfLog(0.1)}, "scans of its run, found");
  std::vector<std::string> words = {SIMULATE, "--output_dir=" + folder_.path(), "--seed=8"};
  for (const std::string& flag : TourFlags()) words.push_back(flag);
  MustSucceed(words);
  ExpectRefused({"--log=" + folder_.Path("log.clf")}, "found another scan 1");
}

TEST_F(SessionTour, DamagedFilesAreRefused) {
  SavePart(0.2);
  const std::string file = Contents(session_);
  folder_.FileWith("s.session", file.substr(0, file.size() / 2));
  ExpectRefused({}, "a whole session, found one that is cut");
  backend::CounterRandom random(1, 2, 3, 4);
  for (int times = 0; times < 10; ++times) {
    std::string damaged = file;
    // Behind the version.
    const std::size_t at =
        30 + static_cast<std::size_t>(random.Uniform() * static_cast<double>(file.size() - 30));
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    folder_.FileWith("s.session", damaged);
    ExpectRefused({}, "expected a");
  }
}

TEST_F(SessionTour, CheckpointsNeedAFile) {
  const CommandResult result = RunCommand(Command(out_, {"--checkpoint_every=1"}));
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "gmapping_spa: error: --checkpoint_every needs --save_session=FILE\n");
}

TEST_F(SessionTour, AFolderThatCannotBeWrittenToIsSaidBeforeTheWork) {
  const CommandResult result =
      RunCommand(Command(out_, {"--save_session=" + Log() + "/no_folder/s"}));
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("cannot make the folder"));
}

TEST_F(SessionTour, WhatMayEndWithOtherBytesIsSaid) {
  EXPECT_THAT(SavePart(0.1, {"--graph_thread=async"}), HasSubstr("may end with other bytes"));
  EXPECT_THAT(SavePart(0.1, {"--backend_timeout_s=30"}), HasSubstr("may end with other bytes"));
  EXPECT_EQ(SavePart(0.1), "");
}

// Of few scans, particles and cells, written by the first version of sessions.
TEST_F(SessionTour, ASessionOfVersion1IsGoneOnWith) {
  const std::vector<std::string> flags = {"--log=" SESSIONS_FOLDER "/version1.clf", "--particles=2",
                                          "--resolution_m=0.2"};
  const std::string whole = folder_.Path("whole");
  Run(whole, flags);
  std::vector<std::string> resumed = flags;
  resumed.push_back("--resume=" SESSIONS_FOLDER "/version1.session");
  Run(out_, resumed);
  EXPECT_GT(ReadRunRecord(out_)["resources"]["resumed_after_scans"], 0);
  const backend::Trajectory expected = ReadTrajectory(whole + "/trajectory.tum"),
                            found = ReadTrajectory(out_ + "/trajectory.tum");
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_LT(Between(found[k].world_T_robot, expected[k].world_T_robot).translation().norm(),
              0.05);
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
