// SPDX-License-Identifier: BSD-3-Clause
// Logs of the CARMEN robot navigation toolkit: one record a line, its type in front.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_CARMEN_READER_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_CARMEN_READER_H_

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/sensor/beams.h"
#include "frontend/sensor/log_options.h"
#include "frontend/sensor/log_record.h"
#include "frontend/sensor/record_fields.h"

namespace gmapping_spa::sensor {

// Reads FLASER, ROBOTLASER1, RAWLASER1 and ODOM records, and PARAM records that tell where the
// front laser is mounted. README.md of this folder has the fields, and what happens to all else.
class CarmenReader : public RecordReader {
 public:
  // `name` stands for the log in messages.
  CarmenReader(std::unique_ptr<std::istream> in, std::string name, const LogOptions& options);

  std::optional<LogRecord> Next() override;
  LogCounts counts() const override;

 private:
  // Puts the next line into line_; false at the end of the file.
  bool ReadLine();
  // Nothing where the record is neither a scan nor odometry. Throws MalformedRecord.
  std::optional<LogRecord> ParseLine();
  ScanRecord ParseFlaser(RecordFields fields);
  ScanRecord ParseRobotLaser(RecordFields fields) const;
  ScanRecord ParseRawLaser(RecordFields fields) const;
  OdometryRecord ParseOdometry(RecordFields fields) const;
  void ParseParameter(RecordFields fields);
  // The ipc time stamp, which ends what is read of a record.
  double ParseStamp(RecordFields& fields) const;
  void ParseBeamsWithAngles(RecordFields& fields, ScanRecord* record) const;
  backend::SE2 mounting() const { return options_.robot_T_laser.value_or(robot_T_front_laser_); }

  std::unique_ptr<std::istream> in_;
  std::string name_;
  LogOptions options_;
  backend::SE2 robot_T_front_laser_;  // from PARAM records
  bool has_mounting_ = false;         // whether there were any

  std::unique_ptr<char[]> buffer_;  // of the line
  std::string_view line_;
  bool line_is_terminated_ = true;
  bool line_is_too_long_ = false;

  std::int64_t num_lines_ = 0;
  std::int64_t num_scans_ = 0;
  std::int64_t num_odometry_ = 0;
  std::int64_t num_ignored_ = 0;
  std::int64_t num_unknown_ = 0;
  std::int64_t num_malformed_ = 0;
  std::int64_t num_assumed_angles_ = 0;
  std::string first_malformed_;  // its message, until it was said
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_CARMEN_READER_H_
