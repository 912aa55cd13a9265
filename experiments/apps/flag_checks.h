// SPDX-License-Identifier: BSD-3-Clause
// Limits of flag values.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_

#include <cstddef>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "backend/enum_names.h"
#include "backend/text.h"

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

// Throws std::runtime_error "--<flag>=<text>: <message>".
[[noreturn]] inline void FailFlag(const char* flag, const std::string& text,
                                  const std::string& message) {
  throw std::runtime_error(std::string("--") + flag + "=" + text + ": " + message);
}

// The finite number that a flag's text holds; throws std::runtime_error with one line if it is
// none.
inline double Number(const char* flag, const std::string& text) {
  const std::optional<double> value = backend::ParseFinite<double>(text);
  if (!value) FailFlag(flag, text, "expected a number");
  return *value;
}

// Likewise of finite numbers between commas, with blanks around them or not.
inline std::vector<double> Numbers(const char* flag, const std::string& text) {
  std::vector<double> numbers;
  std::istringstream in(text);
  for (std::string item; std::getline(in, item, ',');) {
    std::string_view rest = item;
    const std::optional<double> value = backend::ParseFinite<double>(backend::TakeWord(&rest));
    if (!value || !backend::TakeWord(&rest).empty()) {
      FailFlag(flag, text, "expected a number, found '" + item + "'");
    }
    numbers.push_back(*value);
  }
  return numbers;
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_
