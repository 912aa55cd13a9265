// SPDX-License-Identifier: BSD-3-Clause
// What the sensors of a robot say while it moves, however it is driven.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_ROBOT_SENSORS_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_ROBOT_SENSORS_H_

#include <cstddef>

#include "experiments/simulation/log_sink.h"
#include "experiments/simulation/odometry.h"
#include "experiments/simulation/robot_motion.h"
#include "experiments/simulation/scene.h"
#include "experiments/simulation/simulation.h"

namespace gmapping_spa::simulation {

class RobotSensors {
 public:
  // A step is half a turn of the laser: what Sweep relies on.
  static constexpr std::size_t kStepsPerScan = 2;
  static double StepsPerSecond(const LidarOptions& lidar) {
    return lidar.rate_hz * static_cast<double>(kStepsPerScan);
  }

  // How the robot is driven does not matter here: not all options count.
  explicit RobotSensors(const SimulationOptions& options)
      : options_(options), odometry_(options.odometry, options.seed) {}

  // Hands the readings at a step to `sink`, and lets the wheels turn up to the next one, 1 /
  // StepsPerSecond later. The first step is at time 0.
  void Read(const Scene& scene, const MotionStep& step, LogSink* sink);

  // Of the steps to come.
  void SetOdometryNoise(double factor) { odometry_.SetNoise(factor); }
  void SetSlips(double slips_per_m) { odometry_.SetSlips(slips_per_m); }

  const backend::SE2& odom_T_robot() const { return odometry_.odom_T_robot(); }
  // So far.
  SimulationSummary Summary() const;

 private:
  SimulationOptions options_;
  Odometry odometry_;
  std::size_t steps_ = 0;
  SimulationSummary summary_;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_ROBOT_SENSORS_H_
