#include "experiments/apps/command_line.h"

#include <gflags/gflags.h>

#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "experiments/apps/flag_files.h"
#include "experiments/apps/renamed_flags.h"

namespace gmapping_spa::apps {
namespace {

// What a file made of a flag.
struct Setting {
  std::string current_value;
  FlagOfFile of_file;
};

void Set(const FlagOfFile& flag) {
  if (!gflags::SetCommandLineOption(flag.name.c_str(), flag.value.c_str()).empty()) return;
  const std::string type = gflags::GetCommandLineFlagInfoOrDie(flag.name.c_str()).type;
  throw std::runtime_error(flag.place + ": --" + flag.name + ": expected a value of type " + type +
                           ", found '" + flag.value + "'");
}

std::string DescribeOverride(const gflags::CommandLineFlagInfo& flag, const FlagOfFile& of_file) {
  const std::string path = of_file.place.substr(0, of_file.place.rfind(':'));
  return "--" + flag.name + "=" + ShortValue(flag.type, flag.current_value) +
         " (command line) wins over " + of_file.value + " of " +
         std::filesystem::path(path).filename().string();
}

// Takes the --flagfile=... and "--flagfile ..." out of the words.
std::vector<std::string> TakeFlagFiles(std::vector<char*>* words) {
  constexpr std::string_view kPrefix = "flagfile=";
  std::vector<std::string> files;
  std::vector<char*> others;
  bool flags_end = false;
  for (std::size_t k = 0; k < words->size(); ++k) {
    const std::string word = (*words)[k], flag = WithoutDashes(word);
    flags_end |= word == "--";
    if (!flags_end && flag.starts_with(kPrefix)) {
      files.push_back(flag.substr(kPrefix.size()));
    } else if (!flags_end && flag == "flagfile" && k + 1 < words->size()) {
      files.emplace_back((*words)[++k]);
    } else {
      if (!flags_end && k > 0) RefuseFormerName("command line", flag);
      others.push_back((*words)[k]);
    }
  }
  *words = others;
  return files;
}

}  // namespace

ParsedFlags ParseFlags(int* argc, char*** argv) {
  std::vector<char*> words(*argv, *argv + *argc);
  ParsedFlags parsed{.flag_files = TakeFlagFiles(&words), .overrides = {}};
  std::map<std::string, Setting> settings;
  for (const FlagOfFile& flag : ReadFlagFiles(parsed.flag_files)) {
    Set(flag);
    settings[flag.name] = {gflags::GetCommandLineFlagInfoOrDie(flag.name.c_str()).current_value,
                           flag};
  }
  int count = static_cast<int>(words.size());
  words.push_back(nullptr);
  char** begin = words.data();
  gflags::ParseCommandLineNonHelpFlags(&count, &begin, /*remove_flags=*/true);
  *argc = count;
  for (int k = 0; k <= count; ++k) (*argv)[k] = k < count ? begin[k] : nullptr;
  for (const auto& [name, setting] : settings) {
    const gflags::CommandLineFlagInfo flag = gflags::GetCommandLineFlagInfoOrDie(name.c_str());
    if (flag.current_value == setting.current_value) continue;
    parsed.overrides.push_back(DescribeOverride(flag, setting.of_file));
  }
  return parsed;
}

std::string ShortValue(const std::string& type, const std::string& value) {
  if (type != "double") return value;
  std::ostringstream out;
  out << std::stod(value);
  return out.str();
}

}  // namespace gmapping_spa::apps
