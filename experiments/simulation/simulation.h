// SPDX-License-Identifier: BSD-3-Clause
// A robot on a tour through a world, and what its sensors say.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_SIMULATION_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_SIMULATION_H_

#include <cstdint>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "experiments/simulation/lidar.h"
#include "experiments/simulation/log_sink.h"
#include "experiments/simulation/odometry.h"
#include "experiments/simulation/scene.h"
#include "experiments/simulation/way_point_follower.h"

namespace gmapping_spa::simulation {

// From `begin_s` on, before `end_s`.
struct TimeSpan {
  double begin_s = 0.0, end_s = 0.0;
};

struct SimulationOptions {
  std::uint64_t seed = 1;
  double robot_radius_m = 0.5;
  WayPointFollowerOptions follower;
  LidarOptions lidar;
  OdometryOptions odometry;

  // Tours that follow, each from where the robot is carried to from the end of the one before. The
  // wheels stand still and no scans are taken meanwhile.
  std::vector<WayPoints> carried_to;
  double carry_s = 3.0;  // how long that takes

  std::vector<TimeSpan> covered;       // something lies on the laser
  double covered_range_m = 0.0;        // what all beams read then
  std::vector<TimeSpan> without_scan;  // no scans are taken

  int walkers = 0;  // people about the robot: see crowd.h
};

struct SimulationSummary {
  backend::Trajectory world_T_robot;  // the true pose at each scan
  double path_length_m = 0.0;
  backend::SE2 odom_T_robot;  // what raw odometry says in the end
  int slips = 0, bumps = 0;
};

// Drives the tour and hands the readings to `sink`: two of odometry a scan, as robots commonly
// have, from time 0 on. The same arguments give the same readings. Throws std::runtime_error with
// one line when the robot would touch something (it is checked at each reading), does not arrive,
// or no scan is taken.
SimulationSummary Simulate(const Scene& scene, const WayPoints& way_points,
                           const SimulationOptions& options, LogSink* sink);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_SIMULATION_H_
