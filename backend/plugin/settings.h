// SPDX-License-Identifier: BSD-3-Clause
// A back end's own options: described once, checked before a run, read by the optimizer.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_SETTINGS_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_SETTINGS_H_

#include <limits>
#include <map>
#include <span>
#include <string>

#include "backend/plugin/plugin_abi.h"

namespace gmapping_spa::backend {

// One setting: name, type, default, range and help, as users see them.
using SettingDescription = GmappingSpaSettingDescription;

// Descriptions by type. A default is written as a user would write it.
constexpr SettingDescription NumberSetting(
    const char* name, const char* default_value, const char* help, double minimum,
    double maximum = std::numeric_limits<double>::infinity()) {
  return {name, GMAPPING_SPA_SETTING_NUMBER, default_value, minimum, maximum, nullptr, help};
}
constexpr SettingDescription IntegerSetting(const char* name, const char* default_value,
                                            const char* help, int minimum,
                                            int maximum = std::numeric_limits<int>::max()) {
  return {name,
          GMAPPING_SPA_SETTING_INTEGER,
          default_value,
          static_cast<double>(minimum),
          static_cast<double>(maximum),
          nullptr,
          help};
}
constexpr SettingDescription BooleanSetting(const char* name, const char* default_value,
                                            const char* help) {
  return {name, GMAPPING_SPA_SETTING_BOOLEAN, default_value, 0.0, 0.0, nullptr, help};
}
// `choices` are words separated by commas without spaces.
constexpr SettingDescription ChoiceSetting(const char* name, const char* default_value,
                                           const char* choices, const char* help) {
  return {name, GMAPPING_SPA_SETTING_CHOICE, default_value, 0.0, 0.0, choices, help};
}

// The values of described settings: those given, defaults elsewhere. Getters want a name that is
// described, with their type; anything else is an error of the programmer (std::logic_error).
class Settings {
 public:
  // Throws std::runtime_error with one line when a given setting is not described, or its value is
  // not of the type or out of range. The descriptions must outlive the object.
  Settings(std::span<const SettingDescription> descriptions,
           const std::map<std::string, std::string>& given);

  double Number(const std::string& name) const;
  int Integer(const std::string& name) const;
  bool Boolean(const std::string& name) const;
  const std::string& Choice(const std::string& name) const;

 private:
  const std::string& ValueOf(const std::string& name, GmappingSpaSettingType type) const;

  std::span<const SettingDescription> descriptions_;
  std::map<std::string, std::string> values_;
};

// What a setting takes, such as "a number from 0 to 1" or "one of block, cholmod".
std::string RangeOf(const SettingDescription& description);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_SETTINGS_H_
