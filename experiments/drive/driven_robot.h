// SPDX-License-Identifier: BSD-3-Clause
// A simulated robot that is driven by commands.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVEN_ROBOT_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVEN_ROBOT_H_

#include <cstddef>

#include "backend/se2.h"
#include "experiments/simulation/differential_drive.h"
#include "experiments/simulation/log_sink.h"
#include "experiments/simulation/robot_sensors.h"
#include "experiments/simulation/scene.h"
#include "experiments/simulation/simulation.h"

namespace gmapping_spa::drive {

// What counts for the time of one scan.
struct DriveCommand {
  simulation::BodyVelocity velocity;  // wanted; the robot needs time to get there
  double odometry_noise = 1.0;        // OdometryOptions::noise
  double slips_per_m = 0.01;

  friend bool operator==(const DriveCommand& a, const DriveCommand& b) {
    return a.velocity.linear_m_s == b.velocity.linear_m_s &&
           a.velocity.angular_rad_s == b.velocity.angular_rad_s &&
           a.odometry_noise == b.odometry_noise && a.slips_per_m == b.slips_per_m;
  }
};

// Where it goes and what its sensors say depends on scene, start, options and the commands so far,
// not on the time that anything takes.
class DrivenRobot {
 public:
  // The scene outlives this; of the options, tours and walkers do not count.
  DrivenRobot(const simulation::Scene* scene, const backend::SE2& world_T_start,
              const simulation::SimulationOptions& options);

  // Hands the readings of the time of one scan to `sink`, the scan first, and moves so long. Where
  // the robot would touch something it stays, but may turn, and go away from what it touches.
  void Step(const DriveCommand& command, simulation::LogSink* sink);

  double scan_period_s() const { return 1.0 / options_.lidar.rate_hz; }
  double time_s() const { return static_cast<double>(steps_) / steps_per_s_; }
  const backend::SE2& world_T_robot() const { return world_T_robot_; }
  const backend::SE2& odom_T_robot() const { return sensors_.odom_T_robot(); }
  const simulation::BodyVelocity& velocity() const { return velocity_; }
  // What stopped it in the last step; null when nothing did.
  const char* blocked_by() const { return blocked_by_; }
  simulation::SimulationSummary Summary() const { return sensors_.Summary(); }

 private:
  // The velocity without that part that leads into something.
  simulation::BodyVelocity Unblocked(const simulation::BodyVelocity& velocity);

  const simulation::Scene* scene_;
  simulation::SimulationOptions options_;
  double steps_per_s_;
  simulation::RobotSensors sensors_;
  std::size_t steps_ = 0;
  backend::SE2 world_T_robot_;
  simulation::BodyVelocity velocity_;
  const char* blocked_by_ = nullptr;
};

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_DRIVEN_ROBOT_H_
