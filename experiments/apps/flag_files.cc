// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/flag_files.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "backend/text.h"
#include "experiments/apps/renamed_flags.h"

namespace gmapping_spa::apps {
namespace {

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

  std::vector<FlagSetting> Take() { return std::move(flags_); }

 private:
  void ReadFile(const std::string& place, const std::string& path) {
    std::error_code ignored;  // a name that is too long is none either
    if (!std::filesystem::is_regular_file(path, ignored)) {
      throw std::runtime_error(place + ": expected the path of a file, found '" +
                               backend::Printable(path) + "'");
    }
    const std::string file = std::filesystem::canonical(path);
    if (!open_.insert(file).second) {
      throw std::runtime_error(place + ": expected a file that does not name itself, found '" +
                               backend::Printable(path) + "'");
    }
    std::ifstream in(path);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
      line = Trimmed(line);
      if (line.empty() || line[0] == '#') continue;
      const std::string here = path + ":" + std::to_string(number);
      RefuseFormerName(here, WithoutDashes(line));
      const std::optional<FlagSetting> flag = ParseFlag(here, WithoutDashes(line));
      if (!flag) {
        throw std::runtime_error(here +
                                 ": expected --flag=value with a flag of this program, found '" +
                                 backend::Printable(line) + "'");
      }
      if (flag->name == "flagfile") {
        Read(here, flag->value);
      } else {
        flags_.push_back(*flag);
      }
    }
    if (in.bad() || !in.eof()) throw std::runtime_error(path + ": cannot be read");
    open_.erase(file);
  }

  std::vector<FlagSetting> flags_;
  std::set<std::string> open_;
};

}  // namespace

std::vector<FlagSetting> ReadFlagFiles(const std::vector<std::string>& flag_files) {
  Reader reader;
  for (const std::string& paths : flag_files) reader.Read("--flagfile", paths);
  return reader.Take();
}

}  // namespace gmapping_spa::apps
