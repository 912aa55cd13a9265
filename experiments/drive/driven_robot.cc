// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/driven_robot.h"

#include <optional>

namespace gmapping_spa::drive {

using simulation::BodyVelocity;
using simulation::RobotSensors;

DrivenRobot::DrivenRobot(const simulation::Scene* scene, const backend::SE2& world_T_start,
                         const simulation::SimulationOptions& options)
    : scene_(scene),
      options_(options),
      steps_per_s_(RobotSensors::StepsPerSecond(options.lidar)),
      sensors_(options),
      world_T_robot_(world_T_start) {}

BodyVelocity DrivenRobot::Unblocked(const BodyVelocity& velocity) {
  const double step_s = 1.0 / steps_per_s_;
  const Eigen::Vector2d next = Drive(world_T_robot_, velocity, step_s).translation();
  const auto contact =
      scene_->FindContact(next, options_.robot_radius_m, static_cast<double>(steps_ + 1) * step_s);
  if (!contact) return velocity;
  const Eigen::Vector2d now = world_T_robot_.translation();
  const bool leaves =
      (next - contact->world_point).norm() > (now - contact->world_point).norm() + 1e-9;
  if (leaves) return velocity;
  if (velocity.linear_m_s != 0.0) blocked_by_ = contact->what;
  return {0.0, velocity.angular_rad_s};
}

void DrivenRobot::Step(const DriveCommand& command, simulation::LogSink* sink) {
  sensors_.SetOdometryNoise(command.odometry_noise);
  sensors_.SetSlips(command.slips_per_m);
  blocked_by_ = nullptr;
  const simulation::AccelerationLimits limits = {options_.follower.max_acceleration_m_s2,
                                                 options_.follower.max_angular_acceleration_rad_s2};
  for (std::size_t i = 0; i < RobotSensors::kStepsPerScan; ++i) {
    const double step_s = 1.0 / steps_per_s_;
    const BodyVelocity next = Unblocked(Accelerate(velocity_, command.velocity, limits, step_s));
    sensors_.Read(*scene_, {time_s(), world_T_robot_, velocity_, next}, sink);
    velocity_ = next;
    world_T_robot_ = Drive(world_T_robot_, velocity_, step_s);
    ++steps_;
  }
}

}  // namespace gmapping_spa::drive
