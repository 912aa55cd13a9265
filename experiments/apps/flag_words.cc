// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/flag_words.h"

#include <gflags/gflags.h>

namespace gmapping_spa::apps {

std::string WithoutDashes(const std::string& word) {
  const std::size_t begin = word.find_first_not_of('-');
  return begin == 1 || begin == 2 ? word.substr(begin) : "";
}

std::optional<FlagSetting> ParseFlag(const std::string& place, const std::string& flag) {
  gflags::CommandLineFlagInfo info;
  const std::size_t equals = flag.find('=');
  const std::string name = flag.substr(0, equals);
  const bool has_value = equals != std::string::npos;
  if (gflags::GetCommandLineFlagInfo(name.c_str(), &info)) {
    if (has_value) return FlagSetting{info.name, flag.substr(equals + 1), place};
    if (info.type == "bool") return FlagSetting{info.name, "true", place};
    return std::nullopt;
  }
  if (has_value || !name.starts_with("no")) return std::nullopt;
  if (!gflags::GetCommandLineFlagInfo(name.c_str() + 2, &info)) return std::nullopt;
  if (info.type != "bool") return std::nullopt;
  return FlagSetting{info.name, "false", place};
}

}  // namespace gmapping_spa::apps
