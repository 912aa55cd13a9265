// SPDX-License-Identifier: BSD-3-Clause
// A scanning range finder on a robot.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_

#include <cstdint>
#include <numbers>
#include <vector>

#include "backend/se2.h"
#include "experiments/simulation/differential_drive.h"
#include "experiments/simulation/scene.h"

namespace gmapping_spa::simulation {

// Defaults are those of the LSLIDAR N301, the paper's laser: 360 degrees, 10 Hz, up to 30 m. The
// README of its ROS driver (UbiquityRobotics/ur50_lidar on GitHub) lists two revisions: "V0.1 2000
// points per circle", "v0.2 1000 points per circle"; the newer one is taken. The other numbers,
// +-3 cm among them, are those of the vendor's data sheet as commonly quoted: no copy of it could
// be had to check them, and what its "accuracy" means is not known. It is taken for a bound of 95
// %, two standard deviations.
struct LidarOptions {
  int beams = 1000;  // counter-clockwise
  // A whole turn from the first beam to itself, or less: from the first beam to the last.
  double fov_rad = 2.0 * std::numbers::pi;
  double fov_center_rad = 0.0;  // direction of the middle of the field of view, in the laser frame
  double rate_hz = 10.0;
  double max_range_m = 30.0;
  double range_noise_m = 0.015;  // standard deviation
  // Whether the laser moves while it turns, once in 1 / rate_hz. The stamp of a scan is the time at
  // which the middle of the field of view is measured, whose pose explains the scan best.
  bool motion_during_scan = false;
  backend::SE2 robot_T_laser;

  bool all_round() const { return fov_rad >= 2.0 * std::numbers::pi; }
  double start_angle_rad() const { return fov_center_rad - fov_rad / 2.0; }
  // 0 for a single beam.
  double angular_resolution_rad() const {
    return all_round() ? fov_rad / beams : beams > 1 ? fov_rad / (beams - 1) : 0.0;
  }
};

// How the robot moves during a turn of the laser.
struct Sweep {
  double stamp_s = 0.0;
  backend::SE2 world_T_robot;  // at the stamp
  BodyVelocity before, after;  // in the half turns before and after it
};

// The ranges, in m, of the scan with this number. All beams are measured at the stamp, or each at
// its time as the laser moves. Normal noise is added; max_range_m stands for no return.
std::vector<double> Scan(const Scene& scene, const Sweep& sweep, const LidarOptions& options,
                         std::uint64_t seed, std::uint32_t scan);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_LIDAR_H_
