// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/scan_player.h"

#include <algorithm>

#include "frontend/sensor/beams.h"

namespace gmapping_spa::simulation {

void ScanPlayer::OnScan(const OdometryReading& odometry, const LidarOptions& lidar,
                        const std::vector<double>& ranges_m) {
  const sensor::LogOptions options;
  sensor::LaserScan scan;
  scan.index = num_scans_++;
  scan.stamp_s = odometry.stamp_s;
  scan.odom_T_robot = odometry.odom_T_robot;
  // The last digit may have been rounded to beyond half a turn.
  scan.odom_T_robot.theta = backend::WrapAngle(scan.odom_T_robot.theta);
  scan.robot_T_laser = lidar.robot_T_laser;
  scan.beams =
      sensor::MakeBeams(ranges_m, {lidar.start_angle_rad(), lidar.angular_resolution_rad()},
                        options.range_min_m, std::min(options.usable_range_m, lidar.max_range_m));
  play_(scan);
}

}  // namespace gmapping_spa::simulation
