#include "experiments/apps/flag_files.h"

#include <gflags/gflags.h>

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace gmapping_spa::apps {
namespace {

// "name=value" of "--name=value" or "-name=value"; empty for a word that is not a flag.
std::string WithoutDashes(const std::string& word) {
  const std::size_t begin = word.find_first_not_of('-');
  return begin == 1 || begin == 2 ? word.substr(begin) : "";
}

bool IsFlag(const std::string& name, bool has_value) {
  gflags::CommandLineFlagInfo info;
  if (gflags::GetCommandLineFlagInfo(name.c_str(), &info)) return has_value || info.type == "bool";
  return !has_value && name.starts_with("no") &&
         gflags::GetCommandLineFlagInfo(name.c_str() + 2, &info) && info.type == "bool";
}

// Checks the files of a list "a,b", each of them once, so that files naming each other end.
void CheckFiles(const std::string& paths, std::set<std::string>& checked) {
  std::istringstream list(paths);
  std::string path;
  while (std::getline(list, path, ',')) {
    if (!checked.insert(path).second) continue;
    std::ifstream in(path);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      // gflags trims only the left side of a line; so a blank at its end is part of the value.
      line.erase(0, line.find_first_not_of(" \t\r\v\f"));
      if (line.empty() || line[0] == '#') continue;
      const std::string flag = WithoutDashes(line);
      const std::size_t equals = flag.find('=');
      const std::string name = flag.substr(0, equals);
      if (!IsFlag(name, equals != std::string::npos)) {
        std::ostringstream message;
        message << path << ':' << number << ": expected --flag=value with a flag of this program, "
                << "found '" << line << "'";
        throw std::runtime_error(message.str());
      }
      if (name == "flagfile") CheckFiles(flag.substr(equals + 1), checked);
    }
  }
}

}  // namespace

void CheckFlagFiles(const std::vector<std::string>& command_line) {
  constexpr std::string_view kPrefix = "flagfile=";
  std::set<std::string> checked;
  for (std::size_t k = 1; k < command_line.size(); ++k) {
    const std::string flag = WithoutDashes(command_line[k]);
    if (flag.starts_with(kPrefix)) CheckFiles(flag.substr(kPrefix.size()), checked);
    if (flag == "flagfile" && k + 1 < command_line.size()) CheckFiles(command_line[k + 1], checked);
  }
}

}  // namespace gmapping_spa::apps
