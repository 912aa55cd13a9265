// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/record_fields.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "backend/text.h"

namespace gmapping_spa::sensor {
namespace {

constexpr double kMaxMagnitude = 1e9;  // of coordinates and angles
constexpr double kMaxStamp = 1e12;     // s; the year 33658

[[noreturn]] void Fail(const std::string& expected, std::string_view found) {
  throw MalformedRecord("expected " + expected + ", found " +
                        (found.empty() ? "the end of the line" : backend::Quoted(found)));
}

}  // namespace

std::string_view RecordFields::TryWord() { return backend::TakeWord(&rest_); }

std::string_view RecordFields::Word(const char* what) {
  const std::string_view word = TryWord();
  if (word.empty()) Fail(what, word);
  return word;
}

double RecordFields::Number(const char* what) {
  const std::string_view word = TryWord();
  const std::optional<double> value = backend::ParseNumber<double>(word);
  if (!value) Fail(what, word);
  return *value;
}

double RecordFields::BoundedNumber(const char* what, double limit) {
  const std::string_view before = rest_;
  const double value = Number(what);
  if (!(std::abs(value) <= limit)) {
    const std::string of_size =
        std::isfinite(value) ? " of at most " + backend::ShortestText(limit) : std::string();
    Fail((of_size.empty() ? "a finite " : "") + std::string(what) + of_size,
         RecordFields(before).TryWord());
  }
  return value;
}

double RecordFields::FiniteNumber(const char* what) { return BoundedNumber(what, kMaxMagnitude); }

double RecordFields::Stamp() { return BoundedNumber("ipc time stamp in s", kMaxStamp); }

backend::SE2 RecordFields::Pose(const char* what) {
  const double x = FiniteNumber(what), y = FiniteNumber(what), theta = FiniteNumber(what);
  return {x, y, backend::WrapAngle(theta)};
}

std::vector<double> RecordFields::CountedNumbers(const char* what) {
  const std::string_view word = TryWord();
  const auto parsed = backend::ParseNumber<std::uint64_t>(word);
  if (!parsed) Fail("number of " + std::string(what), word);
  const std::uint64_t count = *parsed;
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
