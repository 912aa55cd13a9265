// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/carmen_reader.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "backend/text.h"
#include "frontend/sensor/checked_beams.h"

namespace gmapping_spa::sensor {
namespace {

using backend::Between;
using backend::SE2;

// Room for half a million readings; what is longer is not a log, and must not fill the memory.
constexpr std::size_t kMaxLineBytes = 4 << 20;

// Records of the format without scans of the front laser or odometry.
bool IsIgnored(std::string_view type) {
  return type.starts_with('#') || type.starts_with("NMEA") || type == "SYNC" || type == "TRUEPOS" ||
         type == "RLASER";
}

void SkipWords(RecordFields& fields, int num_words, const char* what) {
  for (int i = 0; i < num_words; ++i) fields.Word(what);
}

}  // namespace

CarmenReader::CarmenReader(std::unique_ptr<std::istream> in, std::string name,
                           const LogOptions& options)
    : in_(std::move(in)),
      name_(std::move(name)),
      options_(options),
      // Not cleared: most logs never touch the greater part of it.
      buffer_(std::make_unique_for_overwrite<char[]>(kMaxLineBytes)) {}

std::optional<LogRecord> CarmenReader::Next() {
  while (ReadLine()) {
    try {
      if (std::optional<LogRecord> record = ParseLine()) return record;
    } catch (const MalformedRecord& malformed) {
      const std::runtime_error error = LogError(name_, num_lines_, malformed.what());
      if (options_.bad_record == BadRecordPolicy::kFail) throw error;
      if (++num_malformed_ == 1) first_malformed_ = error.what();
    }
  }
  if (num_scans_ == 0) {
    throw std::runtime_error(
        name_ + ": no laser scans found (" + std::to_string(num_lines_) + " lines, " +
        std::to_string(num_unknown_) + " records unknown, " + std::to_string(num_ignored_) +
        " of kinds that are not read, " + std::to_string(num_malformed_) + " malformed" +
        (num_malformed_ > 0 ? ", the first: " + first_malformed_ : "") + ")" +
        (num_lines_ == 1 ? "; is it text with a line feed after each record?" : ""));
  }
  if (!first_malformed_.empty()) LOG(WARNING) << "left out: " << first_malformed_;
  first_malformed_.clear();
  return std::nullopt;
}

LogCounts CarmenReader::counts() const {
  return {{"lines", num_lines_},
          {"scan_records", num_scans_},
          {"odometry_records", num_odometry_},
          {"ignored_records", num_ignored_},
          {"unknown_records", num_unknown_},
          {"malformed_records", num_malformed_},
          {"assumed_field_of_view", num_assumed_angles_}};
}

bool CarmenReader::ReadLine() {
  if (in_->eof()) return false;
  in_->getline(buffer_.get(), static_cast<std::streamsize>(kMaxLineBytes));
  auto size = static_cast<std::size_t>(in_->gcount());
  if (in_->bad()) throw LogError(name_, num_lines_ + 1, "expected a line, found a read error");
  if (in_->fail() && size == 0) return false;
  ++num_lines_;
  line_is_too_long_ = in_->fail();
  line_is_terminated_ = !in_->eof();
  if (line_is_too_long_) {
    in_->clear(in_->rdstate() & ~std::ios::failbit);
    in_->ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  } else if (line_is_terminated_) {
    --size;  // the newline was counted, not stored
  }
  if (size > 0 && buffer_[size - 1] == '\r') --size;
  line_ = std::string_view(buffer_.get(), size);
  if (num_lines_ == 1) line_ = backend::WithoutByteOrderMark(line_);
  return true;
}

std::optional<LogRecord> CarmenReader::ParseLine() {
  RecordFields fields(line_);
  const std::string_view type = fields.TryWord();
  if (line_is_too_long_ && !type.starts_with('#')) {
    throw MalformedRecord("expected a record, found a line of more than " +
                          std::to_string(kMaxLineBytes - 1) + " bytes");
  }
  if (type == "FLASER" || type == "ROBOTLASER1" || type == "RAWLASER1") {
    ScanRecord record = type == "FLASER"        ? ParseFlaser(fields)
                        : type == "ROBOTLASER1" ? ParseRobotLaser(fields)
                                                : ParseRawLaser(fields);
    record.line = num_lines_;
    ++num_scans_;
    return record;
  }
  if (type == "ODOM") {
    const OdometryRecord record = ParseOdometry(fields);
    ++num_odometry_;
    return record;
  }
  if (type == "PARAM") {
    ParseParameter(fields);
  } else if (IsIgnored(type)) {
    ++num_ignored_;
  } else if (!type.empty()) {
    ++num_unknown_;
  }
  return std::nullopt;
}

// n r_1..r_n laser_x laser_y laser_theta odom_x odom_y odom_theta ipc_timestamp
ScanRecord CarmenReader::ParseFlaser(RecordFields fields) {
  const std::vector<double> ranges_m = fields.CountedNumbers("ranges");
  const SE2 odom_T_laser = fields.Pose("laser pose");
  ScanRecord record;
  record.has_odometry = true;
  record.scan.odom_T_robot = fields.Pose("robot pose");
  record.scan.stamp_s = ParseStamp(fields);
  record.scan.robot_T_laser = mounting();
  record.told_robot_T_laser = Between(record.scan.odom_T_robot, odom_T_laser);
  record.mounting_is_known = has_mounting_ || options_.robot_T_laser;
  record.scan.beams =
      CheckedBeams(ranges_m, TabulatedAngles(ranges_m.size()), options_, std::nullopt);
  if (!options_.fov_rad) ++num_assumed_angles_;
  return record;
}

// <beams with angles> laser_x laser_y laser_theta robot_x robot_y robot_theta laser_tv laser_rv
// forward_safety_dist side_safety_dist turn_axis ipc_timestamp
ScanRecord CarmenReader::ParseRobotLaser(RecordFields fields) const {
  ScanRecord record;
  ParseBeamsWithAngles(fields, &record);
  const SE2 odom_T_laser = fields.Pose("laser pose");
  record.has_odometry = true;
  record.scan.odom_T_robot = fields.Pose("robot pose");
  record.told_robot_T_laser = Between(record.scan.odom_T_robot, odom_T_laser);
  record.mounting_is_known = options_.robot_T_laser.has_value();
  record.scan.robot_T_laser = options_.robot_T_laser.value_or(*record.told_robot_T_laser);
  SkipWords(fields, 5, "speeds, safety distances and turn axis");
  record.scan.stamp_s = ParseStamp(fields);
  return record;
}

// <beams with angles> ipc_timestamp
ScanRecord CarmenReader::ParseRawLaser(RecordFields fields) const {
  ScanRecord record;
  ParseBeamsWithAngles(fields, &record);
  record.scan.robot_T_laser = mounting();
  record.scan.stamp_s = ParseStamp(fields);
  return record;
}

// x y theta tv rv accel ipc_timestamp
OdometryRecord CarmenReader::ParseOdometry(RecordFields fields) const {
  OdometryRecord record;
  record.odom_T_robot = fields.Pose("robot pose");
  SkipWords(fields, 3, "speeds and acceleration");
  record.stamp_s = ParseStamp(fields);
  return record;
}

// param_name param_value
void CarmenReader::ParseParameter(RecordFields fields) {
  const std::string_view parameter = fields.TryWord();
  if (parameter == "robot_frontlaser_offset") {
    robot_T_front_laser_.x = fields.FiniteNumber("offset of the laser");
  } else if (parameter == "robot_frontlaser_side_offset") {
    robot_T_front_laser_.y = fields.FiniteNumber("offset of the laser");
  } else if (parameter == "robot_frontlaser_angular_offset") {
    robot_T_front_laser_.theta =
        backend::WrapAngle(fields.FiniteNumber("angular offset of the laser"));
  } else {
    return;
  }
  has_mounting_ = true;
}

double CarmenReader::ParseStamp(RecordFields& fields) const {
  const double stamp_s = fields.Stamp();
  // Hand-made logs may lack host and logger time, which nobody needs. But where the file ends
  // within the line, the digits before its end need not be the whole stamp.
  if (fields.TryWord().empty() && !line_is_terminated_) {
    throw MalformedRecord("expected a whole record, found the end of the file");
  }
  return stamp_s;
}

// laser_type start_angle field_of_view angular_resolution maximum_range accuracy remission_mode
// num_readings [ranges] num_remissions [remissions]
void CarmenReader::ParseBeamsWithAngles(RecordFields& fields, ScanRecord* record) const {
  fields.Word("laser type");
  const double start_angle_rad = fields.FiniteNumber("start angle");
  const double fov_rad = fields.FiniteNumber("field of view");
  const double resolution_rad = fields.FiniteNumber("angular resolution");
  const double maximum_range_m = fields.Number("maximum range");
  SkipWords(fields, 2, "accuracy and remission mode");
  const std::vector<double> ranges_m = fields.CountedNumbers("ranges");
  fields.CountedNumbers("remissions");

  BeamAngles angles{start_angle_rad, resolution_rad};
  if (resolution_rad == 0.0 && ranges_m.size() > 1) {
    angles.step_rad = fov_rad / static_cast<double>(ranges_m.size() - 1);
  }
  record->scan.beams = CheckedBeams(ranges_m, angles, options_, maximum_range_m);
  if (maximum_range_m > 0.0) record->maximum_range_m = maximum_range_m;
}

}  // namespace gmapping_spa::sensor
