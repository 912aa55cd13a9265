// SPDX-License-Identifier: BSD-3-Clause
// A stream of laser scans from a sensor log.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_LOG_READER_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_LOG_READER_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::sensor {

// Everything a reader has seen so far, by name, for the run record ("scans", "unknown_records",
// "out_of_order", ...). Zero entries are present, so that a reader of the record sees what was
// looked for.
using LogCounts = std::map<std::string, std::int64_t>;

class LogReader {
 public:
  virtual ~LogReader() = default;

  // The next scan, or nothing at the end of the log. Holds a bounded part of the log in memory.
  // Throws std::runtime_error with one line, "<name>:<line>: <what was expected>", on bad input.
  virtual std::optional<LaserScan> Next() = 0;

  virtual LogCounts counts() const = 0;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_LOG_READER_H_
