// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/progress_bar.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>

namespace gmapping_spa::apps {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

TEST(FormatProgress, ShowsShareAndTimes) {
  EXPECT_EQ(FormatProgress("slam", 1000, 4000, 10.2),
            "slam:  25% 1000/4000 [0:10 elapsed, 0:31 left]");
  EXPECT_EQ(FormatProgress("slam", 3999, 4000, 3999.0),
            "slam:  99% 3999/4000 [1:06:39 elapsed, 0:01 left]");
}

TEST(FormatProgress, PromisesNothingBeforeTheFirstAndAfterTheLastItem) {
  EXPECT_EQ(FormatProgress("slam", 0, 4, 2.0), "slam:   0% 0/4 [0:02 elapsed]");
  EXPECT_EQ(FormatProgress("slam", 4, 4, 61.0), "slam: 100% 4/4 [1:01 elapsed]");
}

TEST(FormatProgress, CountsWhenTheTotalIsUnknown) {
  EXPECT_EQ(FormatProgress("read", 17, 0, 5.0), "read: 17 [0:05 elapsed]");
}

// What a bar that gets two updates a while apart writes to stderr when that is `stderr_fd`.
// Two updates of one bar, with the interval between what it shows.
void UseBar(int stderr_fd, std::chrono::milliseconds interval) {
  const int saved = dup(STDERR_FILENO);
  dup2(stderr_fd, STDERR_FILENO);
  {
    ProgressBar bar("slam", 10, interval);
    bar.Update(2);
    bar.Update(10);
  }
  dup2(saved, STDERR_FILENO);
  close(saved);
}

TEST(ProgressBar, IsSilentWhenStderrIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  UseBar(fileno(file), std::chrono::milliseconds(0));
  EXPECT_EQ(lseek(fileno(file), 0, SEEK_END), 0);
  std::fclose(file);
}

std::string ShownOnATerminal(std::chrono::milliseconds interval) {
  int master = -1, slave = -1;
  EXPECT_EQ(openpty(&master, &slave, nullptr, nullptr, nullptr), 0);
  UseBar(slave, interval);
  close(slave);
  std::string shown;
  std::array<char, 4096> buffer;
  for (ssize_t length = 0; (length = read(master, buffer.data(), buffer.size())) > 0;) {
    shown.append(buffer.data(), length);
  }
  close(master);
  return shown;
}

TEST(ProgressBar, RewritesOneLineOnATerminal) {
  const std::string shown = ShownOnATerminal(std::chrono::milliseconds(0));
  EXPECT_THAT(shown, HasSubstr("\rslam:  20% 2/10"));
  EXPECT_THAT(shown, HasSubstr("\rslam: 100% 10/10"));
  EXPECT_THAT(shown, EndsWith("\n"));
}

TEST(ProgressBar, ShowsTheEndButNoUpdateThatComesTooSoon) {
  const std::string shown = ShownOnATerminal(std::chrono::hours(1));
  EXPECT_THAT(shown, Not(HasSubstr("2/10")));
  EXPECT_THAT(shown, HasSubstr("\rslam: 100% 10/10"));
}

}  // namespace
}  // namespace gmapping_spa::apps
