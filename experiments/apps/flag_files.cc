#include "experiments/apps/flag_files.h"

#include <gflags/gflags.h>

#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace gmapping_spa::apps {
namespace {

struct NameAndValue {
  std::string name, value;
};

// Of "name=value" or "[no]name"; nothing when the program has no such flag.
std::optional<NameAndValue> Parse(const std::string& flag) {
  gflags::CommandLineFlagInfo info;
  const std::size_t equals = flag.find('=');
  const std::string name = flag.substr(0, equals);
  const bool has_value = equals != std::string::npos;
  if (gflags::GetCommandLineFlagInfo(name.c_str(), &info)) {
    if (has_value) return NameAndValue{name, flag.substr(equals + 1)};
    if (info.type == "bool") return NameAndValue{name, "true"};
    return std::nullopt;
  }
  if (has_value || !name.starts_with("no")) return std::nullopt;
  if (!gflags::GetCommandLineFlagInfo(name.c_str() + 2, &info)) return std::nullopt;
  if (info.type != "bool") return std::nullopt;
  return NameAndValue{name.substr(2), "false"};
}

class Reader {
 public:
  // A list "a,b".
  void Read(const std::string& paths) {
    std::istringstream list(paths);
    std::string path;
    while (std::getline(list, path, ',')) ReadFile(path);
  }

  std::map<std::string, FlagOfFile> Take() { return std::move(flags_); }

 private:
  void ReadFile(const std::string& path) {
    if (!open_.insert(path).second) return;  // files that name each other end
    std::ifstream in(path);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      // gflags trims only the left side of a line; so a blank at its end is part of the value.
      line.erase(0, line.find_first_not_of(" \t\r\v\f"));
      if (line.empty() || line[0] == '#') continue;
      const std::optional<NameAndValue> flag = Parse(WithoutDashes(line));
      if (!flag) {
        std::ostringstream message;
        message << path << ':' << number << ": expected --flag=value with a flag of this program, "
                << "found '" << line << "'";
        throw std::runtime_error(message.str());
      }
      if (flag->name == "flagfile") {
        Read(flag->value);
      } else {
        flags_[flag->name] = {flag->value, path};
      }
    }
    open_.erase(path);
  }

  std::map<std::string, FlagOfFile> flags_;
  std::set<std::string> open_;
};

}  // namespace

std::string WithoutDashes(const std::string& word) {
  const std::size_t begin = word.find_first_not_of('-');
  return begin == 1 || begin == 2 ? word.substr(begin) : "";
}

std::map<std::string, FlagOfFile> ReadFlagFiles(const std::vector<std::string>& flag_files) {
  Reader reader;
  for (const std::string& paths : flag_files) reader.Read(paths);
  return reader.Take();
}

}  // namespace gmapping_spa::apps
