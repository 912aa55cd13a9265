// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/output_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class OutputFilesTest : public ::testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_.Path(name); }

  static std::function<void(std::ostream&)> Text(const std::string& text) {
    return [text](std::ostream& out) { out << text; };
  }

  static std::string Contents(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  // The message of constructing with `folder`.
  static std::string ErrorOf(const std::string& folder) {
    return MessageOf([&] { OutputFiles files(folder); });
  }

  TemporaryFolder folder_;
};

TEST_F(OutputFilesTest, FilesAppearTogetherWithCommit) {
  OutputFiles files(Path("deep/er"));
  files.Write("a.txt", Text("A"));
  files.Write("b.txt", Text("B"));
  EXPECT_FALSE(fs::exists(Path("deep/er/a.txt")));
  files.Commit();
  EXPECT_EQ(Contents(Path("deep/er/a.txt")), "A");
  EXPECT_EQ(Contents(Path("deep/er/b.txt")), "B");
  EXPECT_EQ(std::distance(fs::directory_iterator(Path("deep/er")), {}), 2) << "nothing else stays";
}

TEST_F(OutputFilesTest, WithoutCommitThereIsNoTrace) {
  {
    OutputFiles files(Path("new/"));
    files.Write("a.txt", Text("A"));
  }
  EXPECT_FALSE(fs::exists(Path("new")));
}

TEST_F(OutputFilesTest, WithoutCommitOldFilesStayAsTheyAre) {
  std::ofstream(Path("a.txt")) << "old";
  {
    OutputFiles files(Path(""));
    files.Write("a.txt", Text("new"));
  }
  EXPECT_EQ(Contents(Path("a.txt")), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(OutputFilesTest, CommitReplacesOldFiles) {
  std::ofstream(Path("a.txt")) << "old and longer";
  OutputFiles files(Path(""));
  files.Write("a.txt", Text("first try"));
  files.Write("a.txt", Text("new"));
  files.Commit();
  EXPECT_EQ(Contents(Path("a.txt")), "new");
}

TEST_F(OutputFilesTest, AFolderThatWasThereIsNotRemoved) {
  { OutputFiles files(Path("")); }
  EXPECT_TRUE(fs::is_directory(folder_.path()));
}

TEST_F(OutputFilesTest, TemporaryPathsKeepTheExtensionAndAreCommitted) {
  OutputFiles files(Path(""));
  const std::string path = files.TemporaryPath("map.png");
  EXPECT_EQ(fs::path(path).extension(), ".png");
  std::ofstream(path) << "pixels";
  files.Commit();
  EXPECT_EQ(Contents(Path("map.png")), "pixels");
}

TEST_F(OutputFilesTest, AFullDeviceIsAnErrorAndLeavesNothing) {
  {
    OutputFiles files(Path("new"));
    fs::create_symlink("/dev/full", files.TemporaryPath("a.txt"));
    EXPECT_EQ(MessageOf([&] { files.Write("a.txt", Text("A")); }),
              "cannot write '" + Path("new/a.txt") + "': No space left on device");
  }
  EXPECT_FALSE(fs::exists(Path("new")));
}

TEST_F(OutputFilesTest, WhatIsNoFileIsNotReplaced) {
  ASSERT_EQ(mkfifo(Path("pipe").c_str(), 0600), 0);
  OutputFiles files(Path("."));
  EXPECT_THAT(MessageOf([&] { files.Write("pipe", Text("1")); }),
              HasSubstr("expected a regular file or none"));
  EXPECT_TRUE(fs::is_fifo(Path("pipe")));
}

TEST_F(OutputFilesTest, AWriterThatThrowsLeavesNothing) {
  {
    OutputFiles files(Path("new"));
    EXPECT_THROW(files.Write("a.txt", [](std::ostream&) { throw std::runtime_error("no"); }),
                 std::runtime_error);
  }
  EXPECT_FALSE(fs::exists(Path("new")));
}

TEST_F(OutputFilesTest, CommitReplacesAllOrNone) {
  std::ofstream(Path("a.txt")) << "old";
  OutputFiles files(Path(""));
  files.Write("a.txt", Text("new"));
  files.Write("b.txt", Text("new"));
  fs::create_directories(Path("b.txt/in_the_way"));
  EXPECT_THROW(files.Commit(), std::runtime_error);
  EXPECT_EQ(Contents(Path("a.txt")), "old");
}

TEST_F(OutputFilesTest, CommitMissesFilesThatWereNeverWritten) {
  std::ofstream(Path("a.txt")) << "old";
  OutputFiles files(Path(""));
  files.Write("a.txt", Text("new"));
  files.TemporaryPath("map.png");
  EXPECT_THROW(files.Commit(), std::runtime_error);
  EXPECT_EQ(Contents(Path("a.txt")), "old");
}

TEST_F(OutputFilesTest, FoldersThatCannotBeWrittenAreNoticedAtOnce) {
  std::ofstream(Path("file")) << "a file";
  EXPECT_EQ(ErrorOf(Path("file/below")),
            "cannot make the folder '" + Path("file/below") + "': Not a directory");
  EXPECT_THAT(ErrorOf(Path("file")), HasSubstr("'" + Path("file") + "'"));
  EXPECT_THAT(ErrorOf("/proc/self/new"), HasSubstr("cannot make the folder '/proc/self/new'"));
  EXPECT_THAT(ErrorOf("/proc/self"), HasSubstr("cannot write to the folder '/proc/self'"));
  EXPECT_THAT(ErrorOf(""), HasSubstr("empty"));
  for (const std::string& folder : {Path("file/below"), Path("file"), std::string("/proc/self")}) {
    EXPECT_THAT(ErrorOf(folder), Not(HasSubstr("\n")));
  }
}

}  // namespace
}  // namespace gmapping_spa::apps
