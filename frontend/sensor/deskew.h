// SPDX-License-Identifier: BSD-3-Clause
// Scans of a laser that turns while the robot moves, as if all beams were measured at once.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_DESKEW_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_DESKEW_H_

#include <Eigen/Core>
#include <cstddef>

#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::sensor {

// When a beam is measured, since the stamp of the scan, in sweeps: from -0.5 for the first beam to
// 0.5 for the last one, or, where the log tells the sweep, from 0 to 1.
inline double PlaceInSweep(const LaserScan& scan, std::size_t beam) {
  if (scan.beams.size() < 2) return 0.0;
  const double part = static_cast<double>(beam) / static_cast<double>(scan.beams.size() - 1);
  return scan.sweep_s > 0.0 ? part : part - 0.5;
}

// Moves each beam to where the laser is at the stamp of the scan. `motion`: of the robot from the
// first beam to the last one at constant velocity, a twist in the robot frame (m, m, rad). Ranges
// and angles change, the number of beams and their order do not.
LaserScan Deskew(LaserScan scan, const Eigen::Vector3d& motion);

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_DESKEW_H_
