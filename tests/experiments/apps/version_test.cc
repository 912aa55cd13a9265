// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/version.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/run_command.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

TEST(Version, IsUnknownWhereNoCommitIsLinked) {
  EXPECT_EQ(Commit(), "unknown");
  EXPECT_EQ(FullVersion(), ReleaseVersion() + "+unknown");
}

TEST(Version, IsSaidByPrograms) {
  const CommandResult result = RunCommand({SIMULATE, "--version"});
  EXPECT_EQ(result.status, 0);
  EXPECT_THAT(result.out,
              testing::MatchesRegex("simulate version " + ReleaseVersion() + "\\+[-.0-9a-z]+\n"));
}

// commit.cmake, on a folder that holds a file.
class CommitOf : public testing::Test {
 protected:
  CommitOf() { folder_.FileWith("file", "content\n"); }

  CommandResult Git(std::vector<std::string> words) {
    words.insert(words.begin(), {"git", "-C", folder_.path(), "-c", "user.name=a", "-c",
                                 "user.email=a@b", "-c", "commit.gpgsign=false"});
    return RunCommand(words);
  }
  bool HasRepository() {
    return Git({"init", "--quiet"}).status == 0 && Git({"add", "file"}).status == 0 &&
           Git({"commit", "--quiet", "-m", "first"}).status == 0;
  }
  std::string Source(const std::string& folder) {
    const std::string output = output_.Path("commit.cc");
    const CommandResult made =
        RunCommand({CMAKE, "-DSOURCE=" + folder, "-DOUTPUT=" + output, "-P", COMMIT_SCRIPT});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(made.err, "");
    std::ostringstream text;
    text << std::ifstream(output).rdbuf();
    return text.str();
  }

  TemporaryFolder folder_, output_;
};

TEST_F(CommitOf, AFolderWithoutARepositoryIsUnknown) {
  EXPECT_THAT(Source(folder_.path()), testing::HasSubstr("return \"unknown\";"));
}

TEST_F(CommitOf, AFolderWithinTheRepositoryOfSomethingElseIsUnknown) {
  if (!HasRepository()) GTEST_SKIP() << "git is missing";
  const std::string inner = folder_.Path("inner");
  ASSERT_TRUE(std::filesystem::create_directory(inner));
  EXPECT_THAT(Source(inner), testing::HasSubstr("return \"unknown\";"));
}

TEST_F(CommitOf, ARepositoryIsItsCommitAndSaysWhenItWasChanged) {
  if (!HasRepository()) GTEST_SKIP() << "git is missing";
  const std::string commit = Git({"rev-parse", "--short", "HEAD"}).out;
  const std::string expected = "return \"" + commit.substr(0, commit.size() - 1);
  EXPECT_THAT(Source(folder_.path()), testing::HasSubstr(expected + "\";"));
  folder_.FileWith("file", "other content\n");
  EXPECT_THAT(Source(folder_.path()), testing::HasSubstr(expected + "-dirty\";"));
}

}  // namespace
}  // namespace gmapping_spa::apps
