// SPDX-License-Identifier: BSD-3-Clause
// Reading YAML with errors that name the file and the line.
#ifndef GMAPPING_SPA_FRONTEND_MAP_YAML_FILE_H_
#define GMAPPING_SPA_FRONTEND_MAP_YAML_FILE_H_

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gmapping_spa::map {

// A YAML file whose top level is a table of keys. Whatever does not fit is thrown as
// std::runtime_error "<path>[:<line>]: <what was expected, what was found>".
class YamlFile {
 public:
  explicit YamlFile(const std::string& path);

  const std::string& path() const { return path_; }
  bool Has(const std::string& key) const { return root_[key].IsDefined(); }
  // The value of `key`, which must be there.
  YAML::Node Get(const std::string& key) const;
  // Refuses any other key: a misspelt one must not be silently ignored.
  void AllowOnly(const std::vector<std::string_view>& keys) const;

  std::string String(const std::string& key) const;
  // A finite number.
  double Number(const std::string& key) const;
  // Yes or no: 0, 1, or a boolean as YAML writes it (false, True, no, ...).
  bool Flag(const std::string& key) const;
  // Exactly `count` finite numbers; `what` says what they are in the message: "[x, y]".
  std::vector<double> Numbers(const YAML::Node& node, std::size_t count,
                              const std::string& what) const;
  // All items of the sequence at `key`.
  std::vector<YAML::Node> Items(const std::string& key) const;

  [[noreturn]] void Fail(const YAML::Node& at, const std::string& message) const;

 private:
  std::string path_;
  YAML::Node root_;
};

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_YAML_FILE_H_
