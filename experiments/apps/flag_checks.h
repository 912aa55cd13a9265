// Limits of flag values.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_

#include <charconv>
#include <cstddef>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "backend/enum_names.h"

namespace gmapping_spa::apps {

// Returns `value`; throws std::runtime_error with one line unless min <= value <= max. Not a number
// lies in no range.
template <typename T>
T InRange(const char* flag, T value, T min, T max) {
  if (value >= min && value <= max) return value;
  std::ostringstream message;
  message << "--" << flag << ": expected a value from " << min << " to " << max << ", found "
          << value;
  throw std::runtime_error(message.str());
}

// Returns what the name `value` stands for; throws std::runtime_error with one line that lists the
// names when it is none of them.
template <typename Enum, std::size_t kCount>
Enum OneOf(const char* flag, const std::string& value,
           const backend::EnumName<Enum> (&names)[kCount]) {
  if (const std::optional<Enum> found = ValueOf(names, value)) return *found;
  throw std::runtime_error(std::string("--") + flag + ": expected one of " + ListOf(names) +
                           ", found '" + value + "'");
}

// The number that a flag's text holds; throws std::runtime_error with one line if it is none.
inline double Number(const char* flag, const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::runtime_error(std::string("--") + flag + ": expected a number, found '" + text +
                             "'");
  }
  return value;
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_
