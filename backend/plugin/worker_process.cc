// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/worker_process.h"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace gmapping_spa::backend {
namespace {

constexpr double kPatience_s = 1.0;
constexpr int kSocketOfWorker = 3;

[[noreturn]] void FailToStart(const std::string& worker, int error) {
  throw std::runtime_error("cannot start the process of the back end, " + worker + ": " +
                           std::generic_category().message(error));
}

// posix_spawn copies no page tables, however large the program has grown. Returns an error number.
int Spawn(const std::string& worker, const std::string& plugin, int socket, pid_t* process) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, socket, kSocketOfWorker);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t blocked;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGINT);
  sigaddset(&blocked, SIGTERM);
  posix_spawnattr_setsigmask(&attributes, &blocked);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  std::array<std::string, 3> words = {worker, plugin, std::to_string(kSocketOfWorker)};
  std::array<char*, 4> arguments = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  const int error =
      posix_spawn(process, worker.c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

}  // namespace

WorkerProcess::WorkerProcess(const std::string& worker, const std::string& plugin) {
  std::array<int, 2> sockets{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) {
    FailToStart(worker, errno);
  }
  channel_ = std::make_unique<PacketChannel>(sockets[0]);
  const int error = Spawn(worker, plugin, sockets[1], &process_);
  close(sockets[1]);
  if (error != 0) {
    process_ = -1;
    FailToStart(worker, error);
  }
}

WorkerProcess::~WorkerProcess() {
  channel_.reset();  // tells it to end
  if (!EndsWithin(kPatience_s)) Kill();
}

bool WorkerProcess::EndsWithin(double time_s) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(time_s);
  while (process_ > 0) {
    const pid_t ended = waitpid(process_, &status_, WNOHANG);
    if (ended != 0 && !(ended < 0 && errno == EINTR)) {
      if (ended < 0) status_ = 0;  // another part of the program has waited for it
      process_ = -1;
    } else if (std::chrono::steady_clock::now() >= end) {
      return false;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  return true;
}

void WorkerProcess::Kill() {
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

std::string WorkerProcess::End() {
  if (!EndsWithin(kPatience_s)) {
    Kill();
    return "closed its channel";
  }
  if (WIFSIGNALED(status_)) {
    const int signal = WTERMSIG(status_);
    return "crashed with signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
  return "exited with status " + std::to_string(WEXITSTATUS(status_));
}

}  // namespace gmapping_spa::backend
