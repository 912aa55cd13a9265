// SPDX-License-Identifier: BSD-3-Clause
// Killing a process at each step of replacing a set of files. The calls that change the folder are
// defined here in place of the C library's.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "experiments/apps/input_file.h"
#include "experiments/apps/output_files.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace {

int steps = 0;
int kill_at_step = -1;
int fail_at_step = -1;

// Returns whether the step may be made.
bool MayStep() {
  const int step = steps++;
  if (step == kill_at_step) raise(SIGKILL);
  if (step == fail_at_step) errno = EROFS;
  return step != fail_at_step;
}

}  // namespace

extern "C" int rename(const char* from, const char* to) noexcept {
  return MayStep() ? renameat(AT_FDCWD, from, AT_FDCWD, to) : -1;
}

extern "C" int remove(const char* path) noexcept {
  if (!MayStep()) return -1;
  return unlink(path) == 0 ? 0 : rmdir(path);
}

namespace gmapping_spa::apps {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsSubsetOf;
using Files = std::map<std::string, std::string>;  // contents by name

const Files kOld = {{"a", "old"}, {"b", "old"}, {"c", "old"}};
const Files kNew = {{"a", "new"}, {"b", "new"}, {"c", "new"}};

// What users see, who do not look at hidden files.
Files Visible(const std::string& folder) {
  Files files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.')) continue;
    std::ifstream in(entry.path());
    files[name] = {std::istreambuf_iterator<char>(in), {}};
  }
  return files;
}

int HiddenIn(const std::string& folder) {
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    count += entry.path().filename().string().starts_with('.') ? 1 : 0;
  }
  return count;
}

void WriteSet(const std::string& folder, const Files& set) {
  OutputFiles files(folder);
  for (const auto& [name, text] : set) {
    files.Write(name, [&contents = text](std::ostream& out) { out << contents; });
  }
  files.Commit();
}

// Replaces the old set in a process that is killed at a step; returns false when it ended before.
bool IsKilledAt(int step, const std::string& folder) {
  const pid_t child = fork();
  if (child == 0) {
    kill_at_step = step;
    steps = 0;
    WriteSet(folder, kNew);
    _exit(0);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return WIFSIGNALED(status);
}

class OutputFilesKill : public testing::Test {
 protected:
  // Calls `check(folder, step)` with what killing at each step leaves.
  template <typename Check>
  void ForEachStep(const Check& check) {
    int step = 0;
    for (bool killed = true; killed; ++step) {
      const std::string folder = folder_.Path("step" + std::to_string(step));
      WriteSet(folder, kOld);
      killed = IsKilledAt(step, folder);
      check(folder, step);
    }
    EXPECT_GE(step, 8) << "the deciding step, three old files, three new ones, the folder";
  }

  TemporaryFolder folder_;
};

TEST_F(OutputFilesKill, LeavesNoMixtureForAnybodyToSee) {
  ForEachStep([](const std::string& folder, int step) {
    EXPECT_THAT(Visible(folder), AnyOf(IsSubsetOf(kOld), IsSubsetOf(kNew))) << step;
  });
}

TEST_F(OutputFilesKill, LeavesTheOldSetOrTheNewOneForReaders) {
  int old_sets = 0, new_sets = 0;
  ForEachStep([&](const std::string& folder, int step) {
    const auto in = OpenInput(folder + "/b");
    const Files files = Visible(folder);
    EXPECT_THAT(files, AnyOf(kOld, kNew)) << step;
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(*in), {}), files.at("b"));
    ++(files == kOld ? old_sets : new_sets);
  });
  EXPECT_EQ(old_sets, 1) << "before the deciding step";
  EXPECT_GE(new_sets, 7);
}

TEST_F(OutputFilesKill, TheNextRunFindsOneOfTheSetsAndLeavesNothingHidden) {
  ForEachStep([](const std::string& folder, int step) {
    { const OutputFiles files(folder); }
    EXPECT_THAT(Visible(folder), AnyOf(kOld, kNew)) << step;
    EXPECT_EQ(HiddenIn(folder), 0) << step;
  });
}

// Completing a set can be interrupted as well.
TEST_F(OutputFilesKill, WhatIsKilledAgainAndAgainGetsToItsEnd) {
  const std::string folder = folder_.Path("out");
  WriteSet(folder, kOld);
  for (int times = 0; IsKilledAt(times < 10 ? 1 : -1, folder); ++times) {
    EXPECT_THAT(Visible(folder), AnyOf(IsSubsetOf(kOld), IsSubsetOf(kNew)));
  }
  EXPECT_EQ(Visible(folder), kNew);
}

TEST_F(OutputFilesKill, UnfinishedFilesOfAKilledRunAreRemovedAndSaid) {
  const std::string folder = folder_.Path("out");
  ASSERT_TRUE(IsKilledAt(0, folder));
  ASSERT_EQ(HiddenIn(folder), 1);
  const std::string of_user = folder_.FileWith("out/.partial-notes", "mine");
  testing::internal::CaptureStderr();
  { const OutputFiles files(folder); }
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("removed 3 unfinished files of a run that was killed"));
  EXPECT_EQ(HiddenIn(folder), 1);
  EXPECT_TRUE(fs::exists(of_user));
}

TEST_F(OutputFilesKill, FilesOfARunThatGoesOnStay) {
  OutputFiles first(folder_.path());
  first.Write("a", [](std::ostream& out) { out << "first"; });
  {
    OutputFiles second(folder_.path());
    second.Write("b", [](std::ostream& out) { out << "second"; });
    second.Commit();
  }
  first.Commit();
  EXPECT_EQ(Visible(folder_.path()), (Files{{"a", "first"}, {"b", "second"}}));
  EXPECT_EQ(HiddenIn(folder_.path()), 0);
}

// The limit on the size of files stands for a disk that is full.
TEST_F(OutputFilesKill, AFullDiskLeavesTheOldSet) {
  const std::string folder = folder_.Path("out");
  WriteSet(folder, kOld);
  {
    OutputFiles files(folder);
    files.Write("a", [](std::ostream& out) { out << "new"; });
    fs::create_symlink("/dev/full", files.TemporaryPath("b"));
    EXPECT_THROW(files.Write("b", [](std::ostream& out) { out << "new"; }), std::runtime_error);
  }
  EXPECT_EQ(Visible(folder), kOld);
  EXPECT_EQ(HiddenIn(folder), 0);
}

TEST_F(OutputFilesKill, AFolderThatBecomesReadOnlyKeepsTheOldSet) {
  const std::string folder = folder_.Path("out");
  WriteSet(folder, kOld);
  steps = 0;
  fail_at_step = 0;
  EXPECT_THAT(MessageOf([&] { WriteSet(folder, kNew); }), HasSubstr("Read-only file system"));
  fail_at_step = -1;
  EXPECT_EQ(Visible(folder), kOld);
  EXPECT_EQ(HiddenIn(folder), 0);
}

TEST_F(OutputFilesKill, WhatFailsAfterTheDecidingStepIsMadeUpFor) {
  const std::string folder = folder_.Path("out");
  WriteSet(folder, kOld);
  steps = 0;
  fail_at_step = 5;
  EXPECT_THAT(MessageOf([&] { WriteSet(folder, kNew); }), HasSubstr("Read-only file system"));
  fail_at_step = -1;
  CompleteSet(folder);
  EXPECT_EQ(Visible(folder), kNew);
  EXPECT_EQ(HiddenIn(folder), 0);
}

}  // namespace
}  // namespace gmapping_spa::apps
