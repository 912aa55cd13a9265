#include "backend/number_rows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace gmapping_spa::backend {
namespace {

std::vector<std::string_view> SplitAtBlanks(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r\v\f";
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

// The word as it can stand in a message of one line, even when the file is a binary one.
std::string Quoted(std::string_view word) {
  constexpr std::size_t kMaxLength = 40;
  std::string quoted = "'";
  for (const char c : word.substr(0, kMaxLength)) quoted += c > ' ' && c <= '~' ? c : '?';
  return quoted + (word.size() > kMaxLength ? "...'" : "'");
}

}  // namespace

NumberRows::NumberRows(std::istream& in, std::string name, std::string columns)
    : in_(in),
      name_(std::move(name)),
      columns_(std::move(columns)),
      column_count_(SplitAtBlanks(columns_).size()) {}

bool NumberRows::Next() {
  std::string line;
  while (std::getline(in_, line)) {
    ++line_;
    const std::vector<std::string_view> words = SplitAtBlanks(line);
    if (words.empty() || words[0].starts_with('#')) continue;
    if (words.size() != column_count_) {
      Fail(std::to_string(column_count_) + " columns (" + columns_ + ")",
           std::to_string(words.size()));
    }
    row_.clear();
    for (std::string_view word : words) {
      const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
      double value = 0.0;
      const auto [end, error] = std::from_chars(digits.begin(), digits.end(), value);
      if (error != std::errc() || end != digits.end() || !std::isfinite(value)) {
        Fail("a finite number", Quoted(word));
      }
      row_.push_back(value);
    }
    return true;
  }
  if (in_.bad()) throw std::runtime_error(name_ + ": cannot be read");
  return false;
}

void NumberRows::Fail(const std::string& expected, const std::string& found) const {
  throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": expected " + expected +
                           ", found " + found);
}

}  // namespace gmapping_spa::backend
