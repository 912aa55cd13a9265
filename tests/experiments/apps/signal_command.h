// SPDX-License-Identifier: BSD-3-Clause
// Stops a program of the build in the middle of its work, as a user would.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_SIGNAL_COMMAND_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_SIGNAL_COMMAND_H_

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace gmapping_spa::apps {

struct EndOfCommand {
  int status = 0;        // exit status, or 128 + signal as in a shell
  double seconds = 0.0;  // from the signal to the end
};

// Starts a program that works for minutes or for ever, waits until `path` exists, which it makes
// when it is past its start, and a little, and sends the signal.
inline EndOfCommand SignalCommand(std::vector<std::string> command, const std::string& path,
                                  int signal, const std::string& stderr_path = "/dev/null") {
  using Clock = std::chrono::steady_clock;
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen(stderr_path.c_str(), "w", stderr) == nullptr) _exit(126);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  while (!std::filesystem::exists(path) && waitpid(child, nullptr, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const Clock::time_point sent = Clock::now();
  kill(child, signal);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          std::chrono::duration<double>(Clock::now() - sent).count()};
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_SIGNAL_COMMAND_H_
