// Which of several values of a flag counts.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_COMMAND_LINE_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_COMMAND_LINE_H_

#include <map>
#include <string>
#include <vector>

namespace gmapping_spa::apps {

// A flag on the command line wins over any file given by --flagfile, before or behind it; of files,
// the later one wins. (gflags by itself lets the last word win, so that a file behind a flag would
// silently undo it.)
struct ParsedFlags {
  std::vector<std::string> flag_files;             // in the order of the command line
  std::map<std::string, std::string> file_values;  // of all flags, before the command line's
};

// Sets the flags of the program and removes them from `argv`, as
// gflags::ParseCommandLineNonHelpFlags does, which ends the process with status 1 on what it does
// not know.
ParsedFlags ParseFlags(int* argc, char*** argv);

// A line "--particles=5 (command line) wins over 30 of gmapping.flags" for each flag of a file that
// has another value now. Throws as ReadFlagFiles does.
std::vector<std::string> DescribeOverrides(const ParsedFlags& parsed);

// A value of a flag as people write it: gflags prints 0.05 as 0.050000000000000003.
std::string ShortValue(const std::string& type, const std::string& value);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_COMMAND_LINE_H_
