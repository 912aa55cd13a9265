// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/yaml_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "backend/text.h"

namespace gmapping_spa::map {
namespace {

[[noreturn]] void FailAt(const std::string& path, const YAML::Mark& mark,
                         const std::string& message) {
  throw std::runtime_error(path + (mark.is_null() ? "" : ":" + std::to_string(mark.line + 1)) +
                           ": " + backend::Printable(message));
}

// What stands at the node, short enough for a message of one line.
std::string NodeToString(const YAML::Node& node) {
  if (node.IsScalar()) {
    std::string text = node.Scalar().substr(0, 40);
    text.resize(std::min(text.size(), text.find('\n')));
    return std::string("'").append(text).append("'");
  }
  if (node.IsSequence()) return "a list of " + std::to_string(node.size());
  return node.IsMap() ? "a table of keys" : "nothing";
}

}  // namespace

YamlFile::YamlFile(const std::string& path) : path_(path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) {
    throw std::runtime_error(path + ": expected a YAML file, found nothing to read");
  }
  try {
    root_ = YAML::Load(text.str());
  } catch (const YAML::Exception& error) {
    FailAt(path, error.mark, "expected YAML, found: " + error.msg);
  }
  if (!root_.IsMap()) Fail(root_, "expected a table of keys, found " + NodeToString(root_));
}

YAML::Node YamlFile::Get(const std::string& key) const {
  const YAML::Node node = root_[key];
  if (!node) throw std::runtime_error(path_ + ": expected the key '" + key + "', found none");
  return node;
}

void YamlFile::AllowOnly(const std::vector<std::string_view>& keys) const {
  for (const auto& entry : root_) {
    const YAML::Node key = entry.first;
    if (key.IsScalar() && std::find(keys.begin(), keys.end(), key.Scalar()) != keys.end()) continue;
    std::string list;
    for (const std::string_view allowed : keys)
      list.append(list.empty() ? "" : ", ").append(allowed);
    Fail(key, "expected one of the keys " + list + ", found " + NodeToString(key));
  }
}

std::string YamlFile::String(const std::string& key) const {
  const YAML::Node node = Get(key);
  if (!node.IsScalar() || node.Scalar().empty()) {
    Fail(node, "expected text for '" + key + "', found " + NodeToString(node));
  }
  return node.Scalar();
}

double YamlFile::Number(const std::string& key) const {
  const YAML::Node node = Get(key);
  double value = 0.0;
  if (!YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    Fail(node, "expected a number for '" + key + "', found " + NodeToString(node));
  }
  return value;
}

bool YamlFile::Flag(const std::string& key) const {
  const YAML::Node node = Get(key);
  bool value = false;
  if (YAML::convert<bool>::decode(node, value)) return value;
  double number = 0.0;
  if (!YAML::convert<double>::decode(node, number) || (number != 0.0 && number != 1.0)) {
    Fail(node, "expected 0, 1, false or true for '" + key + "', found " + NodeToString(node));
  }
  return number == 1.0;
}

std::vector<double> YamlFile::Numbers(const YAML::Node& node, std::size_t count,
                                      const std::string& what) const {
  if (!node.IsSequence() || node.size() != count) {
    Fail(node, "expected " + what + ", found " + NodeToString(node));
  }
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!YAML::convert<double>::decode(node[i], values[i]) || !std::isfinite(values[i])) {
      Fail(node[i], "expected " + what + ", found " + NodeToString(node[i]) + " in it");
    }
  }
  return values;
}

std::vector<YAML::Node> YamlFile::Items(const std::string& key) const {
  const YAML::Node node = Get(key);
  if (!node.IsSequence()) {
    Fail(node, "expected a list for '" + key + "', found " + NodeToString(node));
  }
  return {node.begin(), node.end()};
}

void YamlFile::Fail(const YAML::Node& at, const std::string& message) const {
  FailAt(path_, at.Mark(), message);
}

}  // namespace gmapping_spa::map
