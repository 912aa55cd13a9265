// SPDX-License-Identifier: BSD-3-Clause
// Scans of a laser that turns slowly, while the robot moves.
#include <algorithm>

#include "frontend/lidar_odometry.h"
#include "frontend/sensor/deskew.h"

namespace gmapping_spa::frontend {

// No longer than from scan to scan.
double LidarOdometry::sweep_s() const {
  return std::clamp(sweep_.value_s(), -usual_duration_s_, usual_duration_s_);
}

// Stamps jitter: what was written at once was not measured at once.
Eigen::Vector3d LidarOdometry::VelocityOf(const backend::SE2& motion, double duration_s) const {
  return backend::Log(motion) / std::max(duration_s, 0.5 * usual_duration_s_);
}

sensor::LaserScan LidarOdometry::Deskewed(const sensor::LaserScan& scan,
                                          const Eigen::Vector3d& velocity) const {
  return sensor::Deskew(scan, sweep_s() * velocity);
}

}  // namespace gmapping_spa::frontend
