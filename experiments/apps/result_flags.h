// SPDX-License-Identifier: BSD-3-Clause
// The flags that the results of a run depend on.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_RESULT_FLAGS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_RESULT_FLAGS_H_

#include <map>
#include <string>
#include <vector>

namespace gmapping_spa::apps {

// All flags of the program but those that name files and folders, say when sessions are written,
// or, like --threads, change the time only. In the order of --help.
std::vector<std::string> ResultFlags();

// Their values now.
std::map<std::string, std::string> ResultFlagValues();

// Throws std::runtime_error with one line, which begins with `name`, when the flag of this run is
// not that of another one.
void CheckResultFlag(const std::string& flag,
                     const std::map<std::string, std::string>& of_other_run,
                     const std::string& name);

// Throws std::runtime_error with one line, which begins with `name`, when the flags of this run are
// not those of another one. Flags that the other program did not have yet must have their defaults.
void CheckResultFlags(const std::map<std::string, std::string>& of_other_run,
                      const std::string& name);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_RESULT_FLAGS_H_
