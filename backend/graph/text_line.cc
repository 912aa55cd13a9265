#include "backend/graph/text_line.h"

#include <algorithm>

namespace gmapping_spa::backend {

std::string_view WithoutByteOrderMark(std::string_view line) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (line.starts_with(kMark)) line.remove_prefix(kMark.size());
  return line;
}

std::string_view WithoutComment(std::string_view line) { return line.substr(0, line.find('#')); }

std::string_view TakeWord(std::string_view* rest) {
  constexpr std::string_view kBlanks = " \t\r\v\f";
  rest->remove_prefix(std::min(rest->find_first_not_of(kBlanks), rest->size()));
  const std::string_view word = rest->substr(0, rest->find_first_of(kBlanks));
  rest->remove_prefix(word.size());
  return word;
}

std::string Quoted(std::string_view word) {
  constexpr std::size_t kMaxLength = 40;
  std::string quoted = "'";
  for (const char c : word.substr(0, kMaxLength)) quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (word.size() > kMaxLength ? "...'" : "'");
}

}  // namespace gmapping_spa::backend
