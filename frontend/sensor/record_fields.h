// SPDX-License-Identifier: BSD-3-Clause
// The fields of one line of a log, taken one after the other.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_RECORD_FIELDS_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_RECORD_FIELDS_H_

#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "backend/se2.h"

namespace gmapping_spa::sensor {

// What was expected and what was found, without the place.
struct MalformedRecord : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Fields are separated by blanks. `what` names a field in messages. Everything but
// TryWord throws MalformedRecord when the field is missing or is not what was asked for.
class RecordFields {
 public:
  explicit RecordFields(std::string_view line) : rest_(line) {}

  std::string_view TryWord();  // empty at the end of the line
  std::string_view Word(const char* what);

  // As backend::ParseNumber: nan and infinity included, and what no double can hold is nan.
  double Number(const char* what);
  // A finite number of sane size: where it is not, later arithmetic would overflow.
  double FiniteNumber(const char* what);
  double Stamp();                       // s
  backend::SE2 Pose(const char* what);  // x y theta, in m and rad; theta gets wrapped
  // A number of readings followed by that many numbers.
  std::vector<double> CountedNumbers(const char* what);

 private:
  double BoundedNumber(const char* what, double limit);

  std::string_view rest_;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_RECORD_FIELDS_H_
