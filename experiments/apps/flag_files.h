// Makes mistakes in flag files visible.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_

#include <map>
#include <string>
#include <vector>

namespace gmapping_spa::apps {

// "name=value" of "--name=value" or "-name=value"; empty for a word that is not a flag.
std::string WithoutDashes(const std::string& word);

struct FlagOfFile {
  std::string value;  // as it is written; "true" or "false" for --[no]name
  std::string path;   // of the file that gives it
};

// gflags skips what it does not understand in a file given by --flagfile, so that a misspelt flag
// would silently run an experiment with the default. This reads flag files (and those that they
// name) in the order in which gflags does, each item a path or several with commas between. Returns
// what they say, the last word about each flag. Throws std::runtime_error "<file>:<line>: expected
// <what>, found <what>" on lines other than --name=value, --[no]name, comments and blanks, and on
// flags that the program does not have.
std::map<std::string, FlagOfFile> ReadFlagFiles(const std::vector<std::string>& flag_files);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_
