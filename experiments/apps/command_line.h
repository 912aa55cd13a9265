// SPDX-License-Identifier: BSD-3-Clause
// Which of several values of a flag counts.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_COMMAND_LINE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_COMMAND_LINE_H_

#include <string>
#include <vector>

namespace gmapping_spa::apps {

struct ParsedFlags {
  // In the order of the command line, as it names them.
  std::vector<std::string> flag_files;
  // A line "--particles=5 (command line) wins over 30 of gmapping.flags" for each flag of a file
  // that the command line sets to something else.
  std::vector<std::string> overrides;
};

// Sets the flags of the program and removes them from `argv`, as
// gflags::ParseCommandLineNonHelpFlags does. But a flag on the command line wins over any file
// given by --flagfile, before or behind it; of files, the later one wins. (gflags by itself lets
// the last word win, so that a file behind a flag would silently undo it.) Throws
// std::runtime_error with one line as ReadFlagFiles does, and likewise on flags that the program
// does not have and values that do not fit (gflags ends the process).
ParsedFlags ParseFlags(int* argc, char*** argv);

// A value of a flag as people write it: gflags prints 0.05 as 0.050000000000000003.
std::string ShortValue(const std::string& type, const std::string& value);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_COMMAND_LINE_H_
