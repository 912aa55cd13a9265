// Makes mistakes in flag files visible.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_

#include <string>
#include <vector>

namespace gmapping_spa::apps {

// gflags skips what it does not understand in a file given by --flagfile, so that a misspelt flag
// would silently run an experiment with the default. This reads all flag files that the words of a
// command line name (and those that these name) and throws std::runtime_error "<file>:<line>:
// expected <what>, found <what>" on lines other than --name=value, --[no]name, comments and blanks,
// and on flags that the program does not have.
void CheckFlagFiles(const std::vector<std::string>& command_line);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_
