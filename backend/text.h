// SPDX-License-Identifier: BSD-3-Clause
// What all readers and writers of text have in common. Numbers are those of std::from_chars and
// std::to_chars: the same in every locale.
#ifndef GMAPPING_SPA_BACKEND_TEXT_H_
#define GMAPPING_SPA_BACKEND_TEXT_H_

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

namespace gmapping_spa::backend {

// The line without the UTF-8 byte order mark that some editors put in front of a file. For the
// first line of a file only.
std::string_view WithoutByteOrderMark(std::string_view line);

// The line up to its first '#'.
std::string_view WithoutComment(std::string_view line);

// Takes the next word off the front of `rest`, and the blanks before it; empty at the end.
std::string_view TakeWord(std::string_view* rest);

// All words of a line.
std::vector<std::string_view> WordsOf(std::string_view line);

// The word as it can stand in a message of one line, even when the file is a binary one.
std::string Quoted(std::string_view word);

// The text of a file with '?' for control characters, as it can stand in a message of one line.
std::string Printable(std::string_view text);

// The number that the whole word is, with or without a plus sign; nothing when it is none. "nan"
// and "inf" are floating-point numbers, and one that is too large or too small for its type is nan.
template <typename Number>
std::optional<Number> ParseNumber(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc()) return number;
  if constexpr (std::is_floating_point_v<Number>) return std::numeric_limits<Number>::quiet_NaN();
  return std::nullopt;
}

// Likewise, but nothing for a number that is not finite.
template <typename Number>
std::optional<Number> ParseFinite(std::string_view word) {
  const std::optional<Number> number = ParseNumber<Number>(word);
  return number && std::isfinite(static_cast<double>(*number)) ? number : std::nullopt;
}

// The shortest text that reads back as the same number.
std::string ShortestText(double number);

// Likewise without an exponent, which readers of time stamps often do not expect.
std::string ShortestFixedText(double number);

// With so many digits after the point.
std::string FixedText(double number, int decimals);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_TEXT_H_
