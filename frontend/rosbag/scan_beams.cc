// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/scan_beams.h"

#include <algorithm>
#include <cmath>

#include "frontend/sensor/checked_beams.h"

namespace gmapping_spa::rosbag {

std::vector<sensor::Beam> BeamsOf(const LaserScanMessage& scan, const sensor::LogOptions& options) {
  sensor::BeamAngles angles{scan.angle_min_rad, scan.angle_increment_rad};
  const std::size_t num_beams = scan.ranges_m.size();
  if (angles.step_rad == 0.0 && num_beams > 1) {
    angles.step_rad =
        (scan.angle_max_rad - scan.angle_min_rad) / static_cast<double>(num_beams - 1);
  }
  sensor::LogOptions limits = options;
  if (scan.range_min_m < options.usable_range_m) {  // false for nan
    limits.range_min_m = std::max(options.range_min_m, scan.range_min_m);
  }
  return sensor::CheckedBeams(scan.ranges_m, angles, limits, scan.range_max_m);
}

double SweepOf(const LaserScanMessage& scan) {
  constexpr double kLongestSweep_s = 1.0;  // what is more is no sweep, or not in seconds
  if (scan.ranges_m.size() < 2 || !(scan.time_increment_s > 0.0)) return 0.0;
  const double sweep_s = scan.time_increment_s * static_cast<double>(scan.ranges_m.size() - 1);
  return sweep_s <= kLongestSweep_s ? sweep_s : 0.0;
}

}  // namespace gmapping_spa::rosbag
