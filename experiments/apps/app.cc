// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/app.h"

#include <gflags/gflags.h>
#include <glog/logging.h>
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "experiments/apps/command_line.h"
#include "experiments/apps/flag_help.h"
#include "experiments/apps/freed_memory.h"
#include "experiments/apps/version.h"

DECLARE_bool(help);
DECLARE_bool(helpshort);
DECLARE_bool(helpfull);
DECLARE_bool(helpxml);

namespace gmapping_spa::apps {
namespace {

// Never destroyed: other code may ask at the end of the process.
ParsedFlags& Parsed() {
  static auto& parsed = *new ParsedFlags;
  return parsed;
}

FlagGroups& Groups() {
  static auto& groups = *new FlagGroups;
  return groups;
}

std::atomic<int> received_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must not take a lock");

void OnSignal(int signal) { received_signal = signal; }

void InstallSignalHandlers() {
  struct sigaction action = {};
  action.sa_handler = OnSignal;
  sigemptyset(&action.sa_mask);
  // A second Ctrl-C ends a program at once that does not get to ThrowIfInterrupted.
  action.sa_flags = SA_RESETHAND;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file that exceeds the user's limit is then an error of the write, which is reported and
  // leaves nothing behind, instead of the end of the process.
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, nullptr);
}

}  // namespace

int RunApp(int argc, char** argv, const char* usage, const FlagGroups& flag_groups,
           const std::function<void()>& run) {
  const std::string program = std::filesystem::path(argv[0]).filename();
  Groups() = flag_groups;
  gflags::SetUsageMessage(usage);
  gflags::SetVersionString(FullVersion());
  // Defaults, so that flags still override them.
  gflags::SetCommandLineOptionWithMode("logtostderr", "true", gflags::SET_FLAGS_DEFAULT);
  gflags::SetCommandLineOptionWithMode("minloglevel", "1", gflags::SET_FLAGS_DEFAULT);
  try {
    Parsed() = ParseFlags(&argc, &argv);
  } catch (const std::exception& error) {
    std::cerr << program << ": error: " << error.what() << '\n';
    return 1;
  }
  // Where gflags prints help by itself, it ends with status 1.
  if (FLAGS_help || FLAGS_helpshort) {
    PrintHelp(program, flag_groups, std::cout);
    return 0;
  }
  if (FLAGS_helpxml) {
    PrintHelpXml(program, flag_groups, std::cout);
    return 0;
  }
  if (FLAGS_helpfull) {
    gflags::ShowUsageWithFlags(argv[0]);
    return 0;
  }
  gflags::HandleCommandLineHelpFlags();
  google::InitGoogleLogging(argv[0]);
  InstallSignalHandlers();
  KeepFreedMemory();
  int status = 0;
  try {
    if (argc > 1) {
      throw std::runtime_error("expected flags only, found '" + std::string(argv[1]) +
                               "' (--help lists the flags)");
    }
    for (const std::string& line : Parsed().overrides) {
      std::cerr << program << ": " << line << '\n';
    }
    run();
    // What was printed is complete only when it has reached the device.
    if (!std::cout.flush()) throw std::runtime_error("cannot write to the standard output");
  } catch (const Interrupted& interrupted) {
    std::cerr << program << ": " << interrupted.what() << '\n';
    status = 128 + ReceivedSignal();
  } catch (const NegativeAnswer& answer) {
    std::cout.flush();
    std::cerr << program << ": " << answer.what() << '\n';
    status = 2;
  } catch (const std::bad_alloc&) {
    std::cerr << program << ": error: out of memory\n";
    status = 1;
  } catch (const std::exception& error) {
    std::cerr << program << ": error: " << error.what() << '\n';
    status = 1;
  }
  google::ShutdownGoogleLogging();
  // A back end may still be at work in a thread of its own, which must not meet destroyed objects.
  if (ReceivedSignal() != 0) {
    std::cout.flush();
    std::fflush(nullptr);
    _exit(status);
  }
  return status;
}

const FlagGroups& FlagsByGroup() { return Groups(); }

const std::vector<std::string>& FlagFiles() { return Parsed().flag_files; }

const std::vector<std::string>& FlagOverrides() { return Parsed().overrides; }

void ReleaseFreedMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

int ReceivedSignal() { return received_signal; }

void ThrowIfInterrupted() {
  if (ReceivedSignal() != 0) throw Interrupted("interrupted");
}

}  // namespace gmapping_spa::apps
