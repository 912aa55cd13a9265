#include "backend/plugin/settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace gmapping_spa::backend {
namespace {

[[noreturn]] void Fail(const std::string& name, const std::string& value,
                       const std::string& expectation) {
  throw std::runtime_error("setting " + name + ": expected " + expectation + ", got '" + value +
                           "'");
}

template <typename Value>
Value ParseAtLeast(const std::string& name, const std::string& text, Value minimum,
                   const char* kind) {
  Value value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || !std::isfinite(static_cast<double>(value)) || value < minimum) {
    std::ostringstream expectation;
    expectation << kind << " of at least " << minimum;
    Fail(name, text, expectation.str());
  }
  return value;
}

}  // namespace

const std::string* SettingsReader::Find(const std::string& name) {
  known_.insert(name);
  const auto found = settings_.find(name);
  return found == settings_.end() ? nullptr : &found->second;
}

double SettingsReader::Number(const std::string& name, double fallback, double minimum) {
  const std::string* const text = Find(name);
  return text == nullptr ? fallback : ParseAtLeast(name, *text, minimum, "a number");
}

int SettingsReader::Integer(const std::string& name, int fallback, int minimum) {
  const std::string* const text = Find(name);
  return text == nullptr ? fallback : ParseAtLeast(name, *text, minimum, "an integer");
}

bool SettingsReader::Flag(const std::string& name, bool fallback) {
  const std::string* const text = Find(name);
  if (text == nullptr) return fallback;
  if (*text != "true" && *text != "false") Fail(name, *text, "true or false");
  return *text == "true";
}

std::string SettingsReader::Choice(const std::string& name,
                                   std::initializer_list<const char*> choices) {
  const std::string* const text = Find(name);
  if (text == nullptr) return *choices.begin();
  std::string all;
  for (const char* choice : choices) {
    if (*text == choice) return choice;
    if (!all.empty()) all += ", ";
    all += choice;
  }
  Fail(name, *text, "one of " + all);
}

void SettingsReader::RejectOthers() const {
  const auto unknown = std::find_if(settings_.begin(), settings_.end(), [&](const auto& setting) {
    return !known_.contains(setting.first);
  });
  if (unknown == settings_.end()) return;
  std::string all;
  for (const std::string& known : known_) {
    if (!all.empty()) all += ", ";
    all += known;
  }
  throw std::runtime_error("unknown setting " + unknown->first + ": expected one of " + all);
}

}  // namespace gmapping_spa::backend
