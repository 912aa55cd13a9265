// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/conversion/carmen_sink.h"

#include <algorithm>
#include <string>

#include "backend/text.h"

namespace gmapping_spa::conversion {
namespace {

using sensor::Beam;
using sensor::BeamStatus;

// For lasers of which nothing is known.
constexpr double kLongestRange_m = 1000.0;

void Append(double number, std::string* line) {
  line->append(" ").append(backend::ShortestText(number));
}

// The ipc time stamp, the host, and the time of the logger, which is not known apart.
void Write(double stamp_s, std::string line, std::ostream& out) {
  const std::string stamp = backend::ShortestFixedText(stamp_s);
  out << line.append(" ").append(stamp).append(" convert_log ").append(stamp).append("\n");
}

}  // namespace

CarmenSink::CarmenSink(std::ostream& out) : out_(out) {
  out_ << "# CARMEN log\n"
          "# PARAM param_name param_value\n"
          "# ODOM x y theta tv rv accel ipc_timestamp ipc_hostname logger_timestamp\n"
          "# RAWLASER1 laser_type start_angle field_of_view angular_resolution maximum_range "
          "accuracy remission_mode num_readings [ranges] num_remissions [remissions] "
          "ipc_timestamp ipc_hostname logger_timestamp\n";
}

void CarmenSink::OnScan(const sensor::ScanRecord& record) {
  const sensor::LaserScan& scan = record.scan;
  if (record.has_odometry) OnOdometry({scan.stamp_s, scan.odom_T_robot});
  if (scan.robot_T_laser != robot_T_laser_) {
    robot_T_laser_ = scan.robot_T_laser;
    const auto write = [&](const char* name, double value) {
      std::string line = "PARAM robot_frontlaser_";
      Append(value, &line.append(name));
      Write(scan.stamp_s, line, out_);
    };
    write("offset", scan.robot_T_laser.x);
    write("side_offset", scan.robot_T_laser.y);
    write("angular_offset", scan.robot_T_laser.theta);
  }
  if (scan.sweep_s > 0.0) ++num_sweeps_;
  const std::vector<Beam>& beams = scan.beams;
  const double fov_rad = beams.back().angle_rad - beams.front().angle_rad;
  const double step_rad = fov_rad / static_cast<double>(std::max<std::size_t>(beams.size(), 2) - 1);
  const double maximum_range_m =
      record.maximum_range_m > 0.0 ? record.maximum_range_m : kLongestRange_m;
  std::string line = "RAWLASER1 0";
  for (const double value : {beams.front().angle_rad, fov_rad, step_rad, maximum_range_m}) {
    Append(value, &line);
  }
  line.append(" 0 0 ").append(std::to_string(beams.size()));
  for (const Beam& beam : beams) {
    // Zero is what readers take for no reading.
    Append(beam.status == BeamStatus::kHit        ? beam.range_m
           : beam.status == BeamStatus::kNoReturn ? maximum_range_m
                                                  : 0.0,
           &line);
  }
  Write(scan.stamp_s, line.append(" 0"), out_);
}

void CarmenSink::OnOdometry(const sensor::OdometryRecord& record) {
  std::string line = "ODOM";
  const backend::SE2& pose = record.odom_T_robot;
  for (const double value : {pose.x, pose.y, pose.theta}) Append(value, &line);
  Write(record.stamp_s, line.append(" 0 0 0"), out_);
}

Losses CarmenSink::losses() const {
  return {
      {"scans lose the time that the laser takes from beam to beam, which CARMEN logs do not hold",
       num_sweeps_}};
}

}  // namespace gmapping_spa::conversion
