// SPDX-License-Identifier: BSD-3-Clause
// One sweep of a planar range finder, with the odometry that belongs to it.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_LASER_SCAN_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_LASER_SCAN_H_

#include <cstdint>
#include <vector>

#include "backend/se2.h"

namespace gmapping_spa::sensor {

// What a beam says.
enum class BeamStatus : std::uint8_t {
  kHit,       // an obstacle at the range
  kNoReturn,  // nothing within the usable range (range >= usable range, or infinite)
  kInvalid,   // no information: nan, negative, below the minimum range
};

struct Beam {
  double angle_rad = 0.0;  // in the laser frame, counter-clockwise from its x axis
  double range_m = 0.0;    // metric range of a hit; the usable range for kNoReturn; 0 for kInvalid
  BeamStatus status = BeamStatus::kInvalid;
};

struct LaserScan {
  std::int64_t index = 0;      // position among the scans of the input, from 0, in input order
  double stamp_s = 0.0;        // time of measurement (CARMEN: the ipc time stamp)
  backend::SE2 odom_T_robot;   // raw odometry at that time
  backend::SE2 robot_T_laser;  // mounting
  std::vector<Beam> beams;     // in order of measurement
  bool has_odometry = true;    // false: the log has none for this scan, odom_T_robot is not set
  // Time from the first beam, which the stamp is that of, to the last one, s. 0: the log does not
  // tell; the stamp is then taken for the middle.
  double sweep_s = 0.0;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_LASER_SCAN_H_
