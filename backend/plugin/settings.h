// Reading a back end's own options.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_SETTINGS_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_SETTINGS_H_

#include <initializer_list>
#include <map>
#include <set>
#include <string>

namespace gmapping_spa::backend {

// Takes values out of Options::settings; every method throws std::runtime_error with one line when
// a value is not of its kind.
class SettingsReader {
 public:
  explicit SettingsReader(const std::map<std::string, std::string>& settings)
      : settings_(settings) {}

  // A finite number of at least `minimum`.
  double Number(const std::string& name, double fallback, double minimum);
  int Integer(const std::string& name, int fallback, int minimum);
  // "true" or "false".
  bool Flag(const std::string& name, bool fallback);
  // One of `choices`; the first one when the setting is absent.
  std::string Choice(const std::string& name, std::initializer_list<const char*> choices);

  // Throws when a setting was not asked for: most likely its name is misspelled.
  void RejectOthers() const;

 private:
  const std::string* Find(const std::string& name);

  const std::map<std::string, std::string>& settings_;
  std::set<std::string> known_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_SETTINGS_H_
