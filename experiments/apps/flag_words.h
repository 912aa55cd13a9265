// SPDX-License-Identifier: BSD-3-Clause
// A flag as it is written on a command line or on a line of a file.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_WORDS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_WORDS_H_

#include <optional>
#include <string>

namespace gmapping_spa::apps {

struct FlagSetting {
  std::string name;   // as the program spells it
  std::string value;  // "true" or "false" for --[no]name
  std::string place;  // "<file>:<line>" or "command line"
};

// "name=value" of "--name=value" or "-name=value"; empty for a word that is not a flag.
std::string WithoutDashes(const std::string& word);

// Of "name=value" or "[no]name", which stands at `place`; nothing when the program has no such
// flag.
std::optional<FlagSetting> ParseFlag(const std::string& place, const std::string& flag);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_WORDS_H_
