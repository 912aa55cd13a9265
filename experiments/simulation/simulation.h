// A robot on a tour through a world, and what its sensors say.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_SIMULATION_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_SIMULATION_H_

#include <cstdint>

#include "backend/trajectory_io.h"
#include "experiments/simulation/lidar.h"
#include "experiments/simulation/log_sink.h"
#include "experiments/simulation/odometry.h"
#include "experiments/simulation/scene.h"
#include "experiments/simulation/way_point_follower.h"

namespace gmapping_spa::simulation {

struct SimulationOptions {
  std::uint64_t seed = 1;
  double robot_radius_m = 0.5;
  WayPointFollowerOptions follower;
  LidarOptions lidar;
  OdometryOptions odometry;
};

struct SimulationSummary {
  backend::Trajectory world_T_robot;  // the true pose at each scan
  double path_length_m = 0.0;
  backend::SE2 odom_T_robot;  // what raw odometry says in the end
  int slips = 0, bumps = 0;
};

// Drives the tour and hands the readings to `sink`: two of odometry a scan, as robots commonly
// have, from time 0 on. The same arguments give the same readings. Throws std::runtime_error with
// one line when the robot would touch something (it is checked at each reading) or does not arrive.
SimulationSummary Simulate(const Scene& scene, const WayPoints& way_points,
                           const SimulationOptions& options, LogSink* sink);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_SIMULATION_H_
