#include "frontend/sensor/record_fields.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "backend/graph/text_line.h"

namespace gmapping_spa::sensor {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr double kMaxMagnitude = 1e9;  // of coordinates and angles
constexpr double kMaxStamp = 1e12;     // s; the year 33658

[[noreturn]] void Fail(const std::string& expected, std::string_view found) {
  throw MalformedRecord("expected " + expected + ", found " +
                        (found.empty() ? "the end of the line" : backend::Quoted(found)));
}

}  // namespace

std::string_view RecordFields::TryWord() {
  const std::size_t begin = rest_.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  rest_.remove_prefix(begin);
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view RecordFields::Word(const char* what) {
  const std::string_view word = TryWord();
  if (word.empty()) Fail(what, word);
  return word;
}

double RecordFields::Number(const char* what) {
  const std::string_view word = TryWord();
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) Fail(what, word);
  if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::quiet_NaN();
  return value;
}

double RecordFields::BoundedNumber(const char* what, double limit) {
  const std::string_view before = rest_;
  const double value = Number(what);
  if (!(std::abs(value) <= limit)) {
    Fail("a finite " + std::string(what), RecordFields(before).TryWord());
  }
  return value;
}

double RecordFields::FiniteNumber(const char* what) { return BoundedNumber(what, kMaxMagnitude); }

double RecordFields::Stamp() { return BoundedNumber("ipc time stamp", kMaxStamp); }

backend::SE2 RecordFields::Pose(const char* what) {
  const double x = FiniteNumber(what), y = FiniteNumber(what), theta = FiniteNumber(what);
  return {x, y, backend::WrapAngle(theta)};
}

std::vector<double> RecordFields::CountedNumbers(const char* what) {
  const std::string_view word = TryWord();
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || end != word.data() + word.size()) {
    Fail("number of " + std::string(what), word);
  }
  // A number takes a blank and a digit at least. Told before any memory is asked for.
  if (count > rest_.size() / 2) {
    throw MalformedRecord("expected " + std::to_string(count) + " " + what +
                          ", found a shorter line");
  }
  std::vector<double> numbers(count);
  for (double& number : numbers) number = Number(what);
  return numbers;
}

}  // namespace gmapping_spa::sensor
