// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/result_flags.h"

#include <gflags/gflags.h>

#include <optional>
#include <set>
#include <stdexcept>

#include "backend/text.h"
#include "experiments/apps/app.h"

namespace gmapping_spa::apps {
namespace {

// As a user would write it: gflags gives numbers 17 digits.
std::string Text(const gflags::CommandLineFlagInfo& info, const std::string& value) {
  if (info.type != "double") return value;
  const std::optional<double> number = backend::ParseNumber<double>(value);
  return number ? backend::ShortestText(*number) : value;
}

}  // namespace

std::vector<std::string> ResultFlags() {
  // Of files it is the content that counts.
  static const std::set<std::string> kNoInfluence = {
      "log",        "world",       "path",         "obstacles",
      "output_dir", "threads",     "save_session", "checkpoint_every",
      "resume",     "map_session", "session",      "closures",
      "view",       "view_port",   "view_address", "view_wait",
      "view_keep",  "view_origins"};
  std::vector<std::string> names;
  for (const FlagGroup& group : FlagsByGroup()) {
    for (const std::string& name : group.flags) {
      if (!kNoInfluence.contains(name)) names.push_back(name);
    }
  }
  return names;
}

std::map<std::string, std::string> ResultFlagValues() {
  std::map<std::string, std::string> values;
  for (const std::string& name : ResultFlags()) {
    values[name] = gflags::GetCommandLineFlagInfoOrDie(name.c_str()).current_value;
  }
  return values;
}

void CheckResultFlag(const std::string& flag,
                     const std::map<std::string, std::string>& of_other_run,
                     const std::string& name) {
  const auto info = gflags::GetCommandLineFlagInfoOrDie(flag.c_str());
  const auto other = of_other_run.find(flag);
  const std::string expected = other == of_other_run.end() ? info.default_value : other->second;
  if (info.current_value == expected) return;
  throw std::runtime_error(name + ": expected the flags of its run, --" + flag + "=" +
                           Text(info, expected) + ", found --" + flag + "=" +
                           Text(info, info.current_value));
}

void CheckResultFlags(const std::map<std::string, std::string>& of_other_run,
                      const std::string& name) {
  std::set<std::string> known;
  for (const std::string& flag : ResultFlags()) {
    known.insert(flag);
    CheckResultFlag(flag, of_other_run, name);
  }
  for (const auto& [flag, value] : of_other_run) {
    if (known.contains(flag)) continue;
    throw std::runtime_error(name + ": its run had --" + flag + "=" + value +
                             ", which this program has not");
  }
}

}  // namespace gmapping_spa::apps
