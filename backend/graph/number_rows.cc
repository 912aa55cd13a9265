#include "backend/graph/number_rows.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "backend/graph/text_line.h"

namespace gmapping_spa::backend {
namespace {

std::vector<std::string_view> Words(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view word = TakeWord(&line); !word.empty(); word = TakeWord(&line)) {
    words.push_back(word);
  }
  return words;
}

}  // namespace

NumberRows::NumberRows(std::istream& in, std::string name, std::string columns)
    : in_(in),
      name_(std::move(name)),
      columns_(std::move(columns)),
      column_count_(Words(columns_).size()) {}

bool NumberRows::Next() {
  std::string line;
  while (std::getline(in_, line)) {
    ++line_;
    const std::string_view text = line_ == 1 ? WithoutByteOrderMark(line) : line;
    const std::vector<std::string_view> words = Words(WithoutComment(text));
    if (words.empty()) continue;
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
