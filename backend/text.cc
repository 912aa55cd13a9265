// SPDX-License-Identifier: BSD-3-Clause
#include "backend/text.h"

#include <algorithm>
#include <array>

namespace gmapping_spa::backend {
namespace {

// `how`: further arguments of std::to_chars.
template <typename... How>
std::string Text(double number, How... how) {
  std::array<char, 512> text;  // 1e308 and 1e-308 have some 310 and 330 characters
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number, how...).ptr};
}

}  // namespace

std::string_view WithoutByteOrderMark(std::string_view line) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (line.starts_with(kMark)) line.remove_prefix(kMark.size());
  return line;
}

std::string_view WithoutComment(std::string_view line) { return line.substr(0, line.find('#')); }

std::string_view TakeWord(std::string_view* rest) {
  const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); };
  const auto begin = std::find_if_not(rest->begin(), rest->end(), is_blank);
  const auto end = std::find_if(begin, rest->end(), is_blank);
  *rest = std::string_view(end, rest->end());
  return {begin, end};
}

std::vector<std::string_view> WordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view word = TakeWord(&line); !word.empty(); word = TakeWord(&line)) {
    words.push_back(word);
  }
  return words;
}

std::string Quoted(std::string_view word) {
  constexpr std::size_t kMaxLength = 40;
  std::string quoted = "'";
  for (const char c : word.substr(0, kMaxLength)) quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (word.size() > kMaxLength ? "...'" : "'");
}

std::string Printable(std::string_view text) {
  std::string printable(text);
  std::replace_if(
      printable.begin(), printable.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; },
      '?');
  return printable;
}

std::string ShortestText(double number) { return Text(number); }

std::string ShortestFixedText(double number) { return Text(number, std::chars_format::fixed); }

std::string FixedText(double number, int decimals) {
  return Text(number, std::chars_format::fixed, decimals);
}

}  // namespace gmapping_spa::backend
