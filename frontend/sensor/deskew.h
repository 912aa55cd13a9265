// SPDX-License-Identifier: BSD-3-Clause
// Scans of a laser that turns while the robot moves, as if all beams were measured at once.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_DESKEW_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_DESKEW_H_

#include <Eigen/Core>
#include <cstddef>

#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::sensor {

// When a beam is measured: -0.5 for the first beam of the sweep, 0.5 for the last one.
inline double PlaceInSweep(std::size_t beam, std::size_t num_beams) {
  return num_beams < 2 ? 0.0 : static_cast<double>(beam) / static_cast<double>(num_beams - 1) - 0.5;
}

// Moves each beam to where the laser is in the middle of the sweep. `motion`: of the robot from the
// first beam to the last one at constant velocity, a twist in the robot frame (m, m, rad). Ranges
// and angles change, the number of beams and their order do not.
LaserScan Deskew(LaserScan scan, const Eigen::Vector3d& motion);

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_DESKEW_H_
