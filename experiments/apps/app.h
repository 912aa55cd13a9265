// SPDX-License-Identifier: BSD-3-Clause
// What every executable shares: start-up, error reporting, interruption.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_APP_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_APP_H_

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/apps/flag_groups.h"

namespace gmapping_spa::apps {

// Thrown after SIGINT or SIGTERM; the message is for the user.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Thrown when every output is complete, and the answer to what the user asked is no; the message
// is that answer.
struct NegativeAnswer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Parses the gflags of the command line (with `usage` and `flag_groups` for --help), starts glog
// (warnings to stderr, unless flags say otherwise), says on stderr which flags of a --flagfile the
// command line overrides, installs handlers for SIGINT and SIGTERM and calls `run`. Returns the
// exit status of the process: 0 when `run` returned and what it printed has been written, and after
// --help; 1 with one line on stderr when it threw, when words are left over on the command line and
// when a flag or a line of a --flagfile is not known; 2 with one line when it threw NegativeAnswer;
// 128 + n when it threw Interrupted after signal n.
int RunApp(int argc, char** argv, const char* usage, const FlagGroups& flag_groups,
           const std::function<void()>& run);

// The groups that RunApp was given: all flags of the program itself.
const FlagGroups& FlagsByGroup();

// The files that --flagfile names, in the order in which they count.
const std::vector<std::string>& FlagFiles();

// What RunApp said about flags that the command line overrides, a line each.
const std::vector<std::string>& FlagOverrides();

// Returns memory that is free to the system, where the C library keeps it otherwise: before work in
// another thread, which gets memory of its own.
void ReleaseFreedMemory();

// SIGINT or SIGTERM when the process has received it, else 0. A second one ends the process at
// once.
int ReceivedSignal();

// Call it once per item of long work that leaves nothing behind when it is interrupted.
void ThrowIfInterrupted();

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_APP_H_
