// SPDX-License-Identifier: BSD-3-Clause
// Runs that are killed again and again, and go on from their sessions.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_KILLED_RUN_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_KILLED_RUN_H_

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace gmapping_spa::apps {

// Starts a program without its words.
inline pid_t Start(std::vector<std::string> command) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  return child;
}

// Kills a program after some time. Returns whether it was still at work.
inline bool IsKilledAfter(double time_s, pid_t child) {
  std::this_thread::sleep_for(std::chrono::duration<double>(time_s));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

// Starts a program and kills it some time after it has written its session anew: a time from the
// start would be before the first session on one machine, and after the end on another. Returns
// whether it was still at work.
inline bool IsKilledAfterASession(double time_s, const std::string& session,
                                  std::vector<std::string> command) {
  const auto written = [&] {
    std::error_code none_yet;
    return std::filesystem::last_write_time(session, none_yet);
  };
  const auto before = written();
  const pid_t child = Start(std::move(command));
  siginfo_t ended{};
  while (ended.si_pid == 0 && written() == before) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
  }
  return IsKilledAfter(time_s, child);
}

// `command` with what writes the session each so many seconds, and goes on with it once it is
// there.
inline std::vector<std::string> WithSession(std::vector<std::string> command,
                                            const std::string& session, double every_s) {
  command.push_back("--save_session=" + session);
  command.push_back("--checkpoint_every=" + std::to_string(every_s));
  if (std::filesystem::exists(session)) command.push_back("--resume=" + session);
  return command;
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_KILLED_RUN_H_
