// SPDX-License-Identifier: BSD-3-Clause
// Runs a program of the build as a user would.
#ifndef GMAPPING_SPA_TESTS_RUN_COMMAND_H_
#define GMAPPING_SPA_TESTS_RUN_COMMAND_H_

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace gmapping_spa {

struct CommandResult {
  int status = 0;  // exit status, or 128 + signal as in a shell
  std::string out;
  std::string err;
};

// Runs `words` (program and arguments, no shell) to its end, with nothing on the standard input.
// Output goes to `stdout_path` instead of `out` if one is given.
inline CommandResult RunCommand(const std::vector<std::string>& words,
                                const std::string& stdout_path = "") {
  // Files instead of pipes: a program that fills both streams cannot get stuck.
  using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
  const File out(stdout_path.empty() ? std::tmpfile() : std::fopen(stdout_path.c_str(), "w"),
                 &std::fclose);
  const File err(std::tmpfile(), &std::fclose);
  if (!out || !err) throw std::runtime_error("RunCommand: cannot open a file for the output");
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("RunCommand: cannot fork");
  if (child == 0) {
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(fileno(out.get()), STDOUT_FILENO);
    dup2(fileno(err.get()), STDERR_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int wait_status = 0;
  if (waitpid(child, &wait_status, 0) != child) throw std::runtime_error("RunCommand: no child");
  CommandResult result;
  result.status = WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
  const auto contents = [](std::FILE* file) {
    std::string text;
    std::rewind(file);
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
    return text;
  };
  if (stdout_path.empty()) result.out = contents(out.get());
  result.err = contents(err.get());
  return result;
}

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_TESTS_RUN_COMMAND_H_
