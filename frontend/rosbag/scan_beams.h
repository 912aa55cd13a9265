// SPDX-License-Identifier: BSD-3-Clause
// From a sensor_msgs/LaserScan to beams with an angle and a status.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_SCAN_BEAMS_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_SCAN_BEAMS_H_

#include <vector>

#include "frontend/rosbag/ros_messages.h"
#include "frontend/sensor/laser_scan.h"
#include "frontend/sensor/log_options.h"

namespace gmapping_spa::rosbag {

// Ranges as REP 117 has them: infinity is no return, and so is range_max and what is longer; minus
// infinity, nan and what is shorter than range_min are invalid. Throws sensor::MalformedRecord
// where there is no beam, or beams span more than a turn.
std::vector<sensor::Beam> BeamsOf(const LaserScanMessage& scan, const sensor::LogOptions& options);

// Time from the first beam to the last one, s; 0 where the message does not tell it.
double SweepOf(const LaserScanMessage& scan);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_SCAN_BEAMS_H_
