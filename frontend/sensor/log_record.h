// SPDX-License-Identifier: BSD-3-Clause
// What a log format is reduced to before scans are put in order: scans and odometry readings, in
// the order of the file.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_LOG_RECORD_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_LOG_RECORD_H_

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "backend/se2.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/log_reader.h"

namespace gmapping_spa::sensor {

struct ScanRecord {
  LaserScan scan;             // its index is given later, its odometry too if it has none
  bool has_odometry = false;  // whether the record came with scan.odom_T_robot
  std::int64_t line = 0;      // in the file, from 1

  double maximum_range_m = 0.0;  // of the laser, as the record says; 0 where it does not

  // Of records whose laser pose may or may not tell the mounting (see LaserMountingReader).
  std::optional<backend::SE2> told_robot_T_laser;
  bool mounting_is_known = false;  // scan.robot_T_laser was said by the log's parameters or options
};

struct OdometryRecord {
  double stamp_s = 0.0;
  backend::SE2 odom_T_robot;
};

using LogRecord = std::variant<ScanRecord, OdometryRecord>;

class RecordReader {
 public:
  virtual ~RecordReader() = default;

  // The next record in the order of the file, or nothing at its end. Stamps and poses are finite,
  // and a scan has at least one beam. Throws std::runtime_error with one line when the log cannot
  // be read on, and at the end of a log without any scan.
  virtual std::optional<LogRecord> Next() = 0;

  virtual LogCounts counts() const = 0;
};

// "<name>:<line>: <message>"
inline std::runtime_error LogError(const std::string& name, std::int64_t line,
                                   const std::string& message) {
  return std::runtime_error(name + ":" + std::to_string(line) + ": " + message);
}

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_LOG_RECORD_H_
