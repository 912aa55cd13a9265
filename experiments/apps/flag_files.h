// SPDX-License-Identifier: BSD-3-Clause
// Reads the files that --flagfile names.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_

#include <string>
#include <vector>

#include "experiments/apps/flag_words.h"

namespace gmapping_spa::apps {

// What the files say, in their order, without blanks around values; those that a file names stand
// where it names them. Each item is a path or several with commas between. (gflags itself skips
// what it does not understand in a file, so that a misspelt flag would silently run an experiment
// with the default.) Throws std::runtime_error "<file>:<line>: expected <what>, found <what>" on
// lines other than
// --name=value, --[no]name, comments and blanks, and on flags that the program does not have; and
// on what is no file, or names itself.
std::vector<FlagSetting> ReadFlagFiles(const std::vector<std::string>& flag_files);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_FILES_H_
