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
#include <thread>
#include <vector>

namespace gmapping_spa::apps {

// Starts a program and kills it after some time. Returns whether it was still at work.
inline bool IsKilledAfter(double time_s, std::vector<std::string> command) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(time_s));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
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
