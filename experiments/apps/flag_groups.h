// SPDX-License-Identifier: BSD-3-Clause
// The flags of a program in groups: what --help, run.json, the flags reference and the studies
// read.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_GROUPS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_GROUPS_H_

#include <initializer_list>
#include <string>
#include <vector>

namespace gmapping_spa::apps {

// Each flag of a program belongs to one group; those in no group are of the libraries.
struct FlagGroup {
  std::string name;   // one word, for programs
  std::string title;  // for people
  std::vector<std::string> flags;
};

using FlagGroups = std::vector<FlagGroup>;

inline FlagGroups Join(std::initializer_list<FlagGroups> lists) {
  FlagGroups joined;
  for (const FlagGroups& groups : lists) joined.insert(joined.end(), groups.begin(), groups.end());
  return joined;
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_GROUPS_H_
