#include "experiments/apps/command_line.h"

#include <gflags/gflags.h>

#include <filesystem>
#include <sstream>
#include <string_view>

#include "experiments/apps/flag_files.h"

namespace gmapping_spa::apps {
namespace {

// Parses these words, the first of which names the program; returns those that are not flags.
std::vector<char*> ParseWords(std::vector<char*> words) {
  int count = static_cast<int>(words.size());
  words.push_back(nullptr);
  char** begin = words.data();
  gflags::ParseCommandLineNonHelpFlags(&count, &begin, /*remove_flags=*/true);
  return {begin, begin + count};
}

}  // namespace

ParsedFlags ParseFlags(int* argc, char*** argv) {
  constexpr std::string_view kPrefix = "flagfile=";
  ParsedFlags parsed;
  std::vector<char*> of_files = {(*argv)[0]}, others = {(*argv)[0]};
  bool flags_end = false;
  for (int k = 1; k < *argc; ++k) {
    const std::string word = (*argv)[k], flag = WithoutDashes(word);
    flags_end |= word == "--";
    if (!flags_end && flag.starts_with(kPrefix)) {
      of_files.push_back((*argv)[k]);
      parsed.flag_files.push_back(flag.substr(kPrefix.size()));
    } else if (!flags_end && flag == "flagfile" && k + 1 < *argc) {
      of_files.push_back((*argv)[k]);
      of_files.push_back((*argv)[++k]);
      parsed.flag_files.emplace_back((*argv)[k]);
    } else {
      others.push_back((*argv)[k]);
    }
  }
  ParseWords(of_files);
  std::vector<gflags::CommandLineFlagInfo> flags;
  gflags::GetAllFlags(&flags);
  for (const gflags::CommandLineFlagInfo& flag : flags) {
    parsed.file_values[flag.name] = flag.current_value;
  }
  // Or gflags would read the last file once more.
  gflags::SetCommandLineOption("flagfile", "");
  const std::vector<char*> rest = ParseWords(others);
  *argc = static_cast<int>(rest.size());
  for (int k = 0; k < *argc; ++k) (*argv)[k] = rest[k];
  (*argv)[*argc] = nullptr;
  return parsed;
}

std::vector<std::string> DescribeOverrides(const ParsedFlags& parsed) {
  std::vector<std::string> lines;
  for (const auto& [name, of_file] : ReadFlagFiles(parsed.flag_files)) {
    const gflags::CommandLineFlagInfo flag = gflags::GetCommandLineFlagInfoOrDie(name.c_str());
    if (flag.current_value == parsed.file_values.at(name)) continue;
    lines.push_back("--" + name + "=" + ShortValue(flag.type, flag.current_value) +
                    " (command line) wins over " + of_file.value + " of " +
                    std::filesystem::path(of_file.path).filename().string());
  }
  return lines;
}

std::string ShortValue(const std::string& type, const std::string& value) {
  if (type != "double") return value;
  std::ostringstream out;
  out << std::stod(value);
  return out.str();
}

}  // namespace gmapping_spa::apps
