// SPDX-License-Identifier: BSD-3-Clause
// What gmapping_spa leaves behind when it is stopped or fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "tests/experiments/apps/gmapping_spa_tour.h"
#include "tests/experiments/apps/signal_command.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::SizeIs;

TEST_F(GmappingSpaTour, InterruptedRunWritesWhatItHasAndSaysSo) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string output_dir = folder_.Path("out" + std::to_string(signal));
    EXPECT_EQ(SignalCommand(Command(output_dir, {"--particles=100", "--linear_update_m=0.05"}),
                            output_dir, signal)
                  .status,
              128 + signal);
    EXPECT_THAT(FilesIn(output_dir), SizeIs(kByteIdentical.size() + 1));
    const Json record = ReadRunRecord(output_dir);
    EXPECT_EQ(record["interrupted"]["signal"], signal);
    EXPECT_EQ(record["interrupted"]["scans"], record["counts"]["scans"]);
    std::ifstream trajectory(output_dir + "/trajectory.tum");
    const backend::Trajectory poses = backend::ReadTum(trajectory, "trajectory.tum");
    EXPECT_EQ(record["counts"]["scans"], poses.size());
  }
}

TEST_F(GmappingSpaTour, LogThatBreaksOffLeavesNothingBehind) {
  ASSERT_EQ(RunCommand({"cp", Log(), folder_.Path("log.clf")}).status, 0);
  ASSERT_EQ(RunCommand({"gzip", "-n", folder_.Path("log.clf")}).status, 0);
  const std::string truncated = folder_.Path("log.clf.gz");
  std::filesystem::resize_file(truncated, std::filesystem::file_size(truncated) - 20);
  const std::string output_dir = folder_.Path("out");
  const auto result = RunCommand(Command(output_dir, {"--log=" + truncated}));
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "gmapping_spa: error: " + truncated + ": truncated or corrupt gzip file\n");
  EXPECT_FALSE(std::filesystem::exists(output_dir));
}

TEST_F(GmappingSpaTour, FailedRunKeepsAnEarlierResult) {
  const std::string output_dir = folder_.Path("out");
  std::filesystem::copy(Result(), output_dir);
  const std::string broken = folder_.FileWith("log.clf", Contents(Log()) + "FLASER -1\n");
  EXPECT_EQ(RunCommand(Command(output_dir, {"--log=" + broken, "--bad_record=fail"})).status, 1);
  EXPECT_THAT(FilesIn(output_dir), SizeIs(kByteIdentical.size() + 1));
  ExpectSameResult(Result(), output_dir);
  EXPECT_EQ(Contents(output_dir + "/run.json"), Contents(Result("run.json")));
}

}  // namespace
}  // namespace gmapping_spa::apps
