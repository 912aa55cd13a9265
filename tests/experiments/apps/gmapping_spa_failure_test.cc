// SPDX-License-Identifier: BSD-3-Clause
// What gmapping_spa leaves behind when it fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/experiments/apps/gmapping_spa_tour.h"

namespace gmapping_spa::apps {
namespace {

using ::testing::SizeIs;

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
