// SPDX-License-Identifier: BSD-3-Clause
// Names of the values of an enum, as command lines and files have them.
//
//   constexpr EnumName<LossKind> kNames[] = {{"none", LossKind::kNone}, ...};
//
// is all that an enum needs for both ways.
#ifndef GMAPPING_SPA_BACKEND_ENUM_NAMES_H_
#define GMAPPING_SPA_BACKEND_ENUM_NAMES_H_

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gmapping_spa::backend {

template <typename Enum>
struct EnumName {
  const char* name;
  Enum value;
};

// "unknown" for a value that is not in the table.
template <typename Enum, std::size_t kCount>
constexpr const char* NameOf(const EnumName<Enum> (&names)[kCount], Enum value) {
  for (const EnumName<Enum>& entry : names) {
    if (entry.value == value) return entry.name;
  }
  return "unknown";
}

// Nothing for a name that is not in the table.
template <typename Enum, std::size_t kCount>
constexpr std::optional<Enum> ValueOf(const EnumName<Enum> (&names)[kCount],
                                      std::string_view name) {
  for (const EnumName<Enum>& entry : names) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

// All names, for messages: "none, huber, cauchy".
template <typename Enum, std::size_t kCount>
std::string ListOf(const EnumName<Enum> (&names)[kCount]) {
  std::string list;
  for (const EnumName<Enum>& entry : names) {
    if (!list.empty()) list += ", ";
    list += entry.name;
  }
  return list;
}

// The value of a name; for a name that is not in the table throws std::runtime_error "expected
// <what> out of <names>, got '<name>'".
template <typename Enum, std::size_t kCount>
Enum FromName(const EnumName<Enum> (&names)[kCount], const std::string& name, const char* what) {
  if (const std::optional<Enum> value = ValueOf(names, name)) return *value;
  throw std::runtime_error(std::string("expected ") + what + " out of " + ListOf(names) +
                           ", got '" + name + "'");
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_ENUM_NAMES_H_
