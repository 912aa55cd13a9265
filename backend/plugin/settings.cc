// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/settings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "backend/text.h"

namespace gmapping_spa::backend {
namespace {

std::vector<std::string> ChoicesOf(const SettingDescription& description) {
  std::vector<std::string> choices;
  std::istringstream words(description.choices == nullptr ? "" : description.choices);
  for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
  return choices;
}

template <typename Number>
bool IsInRange(const std::string& value, const SettingDescription& description) {
  const std::optional<Number> number = ParseFinite<Number>(value);
  return number && *number >= description.minimum && *number <= description.maximum;
}

bool Fits(const std::string& value, const SettingDescription& description) {
  switch (description.type) {
    case GMAPPING_SPA_SETTING_NUMBER:
      return IsInRange<double>(value, description);
    case GMAPPING_SPA_SETTING_INTEGER:
      return IsInRange<int>(value, description);
    case GMAPPING_SPA_SETTING_BOOLEAN:
      return value == "true" || value == "false";
    case GMAPPING_SPA_SETTING_CHOICE: {
      const std::vector<std::string> choices = ChoicesOf(description);
      return std::find(choices.begin(), choices.end(), value) != choices.end();
    }
    default:
      return false;
  }
}

template <typename Texts>
std::string Join(const Texts& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

const SettingDescription* Find(std::span<const SettingDescription> descriptions,
                               const std::string& name) {
  const auto found = std::find_if(descriptions.begin(), descriptions.end(),
                                  [&](const SettingDescription& one) { return name == one.name; });
  return found == descriptions.end() ? nullptr : &*found;
}

void Check(std::span<const SettingDescription> descriptions, const std::string& name,
           const std::string& value) {
  const SettingDescription* const description = Find(descriptions, name);
  if (description == nullptr) {
    std::vector<std::string> names;
    names.reserve(descriptions.size());
    for (const SettingDescription& known : descriptions) names.emplace_back(known.name);
    throw std::runtime_error("unknown setting " + name + ": expected " +
                             (names.empty() ? "no settings" : "one of " + Join(names)));
  }
  if (!Fits(value, *description)) {
    throw std::runtime_error("setting " + name + ": expected " + RangeOf(*description) + ", got '" +
                             value + "'");
  }
}

}  // namespace

Settings::Settings(std::span<const SettingDescription> descriptions,
                   const std::map<std::string, std::string>& given)
    : descriptions_(descriptions), values_(given) {
  for (const auto& [name, value] : given) Check(descriptions, name, value);
  for (const SettingDescription& one : descriptions)
    values_.try_emplace(one.name, one.default_value);
}

const std::string& Settings::ValueOf(const std::string& name, GmappingSpaSettingType type) const {
  const SettingDescription* const description = Find(descriptions_, name);
  if (description == nullptr || description->type != type) {
    throw std::logic_error("setting " + name + " is not described, or with another type");
  }
  return values_.at(name);
}

double Settings::Number(const std::string& name) const {
  return ParseFinite<double>(ValueOf(name, GMAPPING_SPA_SETTING_NUMBER)).value();
}

int Settings::Integer(const std::string& name) const {
  return ParseFinite<int>(ValueOf(name, GMAPPING_SPA_SETTING_INTEGER)).value();
}

bool Settings::Boolean(const std::string& name) const {
  return ValueOf(name, GMAPPING_SPA_SETTING_BOOLEAN) == "true";
}

const std::string& Settings::Choice(const std::string& name) const {
  return ValueOf(name, GMAPPING_SPA_SETTING_CHOICE);
}

std::string RangeOf(const SettingDescription& description) {
  if (description.type == GMAPPING_SPA_SETTING_BOOLEAN) return "true or false";
  if (description.type == GMAPPING_SPA_SETTING_CHOICE) {
    return "one of " + Join(ChoicesOf(description));
  }
  const bool integer = description.type == GMAPPING_SPA_SETTING_INTEGER;
  std::ostringstream range;
  range << (integer ? "an integer" : "a number");
  const bool open = integer ? description.maximum >= std::numeric_limits<int>::max()
                            : std::isinf(description.maximum);
  if (open) {
    range << " of at least " << description.minimum;
  } else {
    range << " from " << description.minimum << " to " << description.maximum;
  }
  return range.str();
}

}  // namespace gmapping_spa::backend
