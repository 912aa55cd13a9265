#include "experiments/apps/flag_files.h"

#include <gflags/gflags.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "experiments/apps/renamed_flags.h"

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
    if (has_value) return NameAndValue{info.name, flag.substr(equals + 1)};
    if (info.type == "bool") return NameAndValue{info.name, "true"};
    return std::nullopt;
  }
  if (has_value || !name.starts_with("no")) return std::nullopt;
  if (!gflags::GetCommandLineFlagInfo(name.c_str() + 2, &info)) return std::nullopt;
  if (info.type != "bool") return std::nullopt;
  return NameAndValue{info.name, "false"};
}

// Without blanks around it, the line ends of other systems, and the mark of Unicode that some
// editors begin files with.
std::string Trimmed(std::string line) {
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  const char* blanks = " \t\r\v\f";
  line.erase(line.find_last_not_of(blanks) + 1);
  line.erase(0, line.find_first_not_of(blanks));
  return line;
}

class Reader {
 public:
  // A list "a,b", which stands at `place`.
  void Read(const std::string& place, const std::string& paths) {
    std::istringstream list(paths + ",");
    for (std::string path; std::getline(list, path, ',');) ReadFile(place, path);
  }

  std::vector<FlagOfFile> Take() { return std::move(flags_); }

 private:
  void ReadFile(const std::string& place, const std::string& path) {
    if (!std::filesystem::is_regular_file(path)) {
      throw std::runtime_error(place + ": expected the path of a file, found '" + path + "'");
    }
    const std::string file = std::filesystem::canonical(path);
    if (!open_.insert(file).second) {
      throw std::runtime_error(place + ": expected a file that does not name itself, found '" +
                               path + "'");
    }
    std::ifstream in(path);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      line = Trimmed(line);
      if (line.empty() || line[0] == '#') continue;
      const std::string here = path + ":" + std::to_string(number);
      RefuseFormerName(here, WithoutDashes(line));
      const std::optional<NameAndValue> flag = Parse(WithoutDashes(line));
      if (!flag) {
        throw std::runtime_error(
            here + ": expected --flag=value with a flag of this program, found '" + line + "'");
      }
      if (flag->name == "flagfile") {
        Read(here, flag->value);
      } else {
        flags_.push_back({flag->name, flag->value, here});
      }
    }
    if (in.bad() || !in.eof()) throw std::runtime_error(path + ": cannot be read");
    open_.erase(file);
  }

  std::vector<FlagOfFile> flags_;
  std::set<std::string> open_;
};

}  // namespace

std::string WithoutDashes(const std::string& word) {
  const std::size_t begin = word.find_first_not_of('-');
  return begin == 1 || begin == 2 ? word.substr(begin) : "";
}

std::vector<FlagOfFile> ReadFlagFiles(const std::vector<std::string>& flag_files) {
  Reader reader;
  for (const std::string& paths : flag_files) reader.Read("--flagfile", paths);
  return reader.Take();
}

}  // namespace gmapping_spa::apps
