// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/command_line.h"

#include <gflags/gflags.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>

#include "experiments/apps/flag_files.h"
#include "experiments/apps/renamed_flags.h"

namespace gmapping_spa::apps {
namespace {

// What a file made of a flag.
struct SettingOfFile {
  std::string current_value;
  FlagSetting flag;
};

void Set(const FlagSetting& flag) {
  if (!gflags::SetCommandLineOption(flag.name.c_str(), flag.value.c_str()).empty()) return;
  const std::string type = gflags::GetCommandLineFlagInfoOrDie(flag.name.c_str()).type;
  throw std::runtime_error(flag.place + ": --" + flag.name + ": expected a value of type " + type +
                           ", found '" + flag.value + "'");
}

std::string OverrideMessage(const gflags::CommandLineFlagInfo& flag, const FlagSetting& of_file) {
  const std::string path = of_file.place.substr(0, of_file.place.rfind(':'));
  return "--" + flag.name + "=" + ShortValue(flag.type, flag.current_value) +
         " (command line) wins over " + of_file.value + " of " +
         std::filesystem::path(path).filename().string();
}

struct Words {
  std::vector<std::string> flag_files;
  std::vector<FlagSetting> flags;
  std::vector<char*> others;  // the program first
};

// The flag of a word, with the next word as its value where it has none.
FlagSetting FlagOf(const std::string& flag, const char* next_word, bool* takes_next) {
  const std::string place = "command line";
  RefuseFormerName(place, flag);
  gflags::CommandLineFlagInfo info;
  *takes_next = gflags::GetCommandLineFlagInfo(flag.c_str(), &info) && info.type != "bool";
  if (*takes_next) {
    if (next_word == nullptr) throw std::runtime_error("--" + flag + ": expected a value");
    return {info.name, next_word, place};
  }
  if (const auto setting = ParseFlag(place, flag)) return *setting;
  throw std::runtime_error("unknown flag '--" + flag.substr(0, flag.find('=')) +
                           "' (--help lists the flags)");
}

Words SortWords(const std::vector<char*>& words) {
  Words sorted;
  bool flags_end = false;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string word = words[k], flag = WithoutDashes(word);
    if (!flags_end && word == "--") {
      flags_end = true;
    } else if (k == 0 || flags_end || flag.empty()) {
      sorted.others.push_back(words[k]);
    } else {
      bool takes_next = false;
      const char* next_word = k + 1 < words.size() ? words[k + 1] : nullptr;
      const FlagSetting setting = FlagOf(flag, next_word, &takes_next);
      if (takes_next) ++k;
      if (setting.name == "flagfile") {
        sorted.flag_files.push_back(setting.value);
      } else {
        sorted.flags.push_back(setting);
      }
    }
  }
  return sorted;
}

}  // namespace

ParsedFlags ParseFlags(int* argc, char*** argv) {
  const Words words = SortWords({*argv, *argv + *argc});
  ParsedFlags parsed{.flag_files = words.flag_files, .overrides = {}};
  std::map<std::string, SettingOfFile> of_files;
  for (const FlagSetting& flag : ReadFlagFiles(parsed.flag_files)) {
    Set(flag);
    of_files[flag.name] = {gflags::GetCommandLineFlagInfoOrDie(flag.name.c_str()).current_value,
                           flag};
  }
  for (const FlagSetting& flag : words.flags) Set(flag);
  for (const auto& [name, setting] : of_files) {
    const gflags::CommandLineFlagInfo flag = gflags::GetCommandLineFlagInfoOrDie(name.c_str());
    if (flag.current_value == setting.current_value) continue;
    parsed.overrides.push_back(OverrideMessage(flag, setting.flag));
  }
  *argc = static_cast<int>(words.others.size());
  std::copy(words.others.begin(), words.others.end(), *argv);
  (*argv)[*argc] = nullptr;
  int program_only = 1;
  gflags::ParseCommandLineNonHelpFlags(&program_only, argv, /*remove_flags=*/false);
  return parsed;
}

std::string ShortValue(const std::string& type, const std::string& value) {
  if (type != "double") return value;
  std::ostringstream out;
  out << std::stod(value);
  return out.str();
}

}  // namespace gmapping_spa::apps
