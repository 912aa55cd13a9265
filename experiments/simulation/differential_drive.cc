// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/differential_drive.h"

#include <algorithm>

namespace gmapping_spa::simulation {

BodyVelocity ToBodyVelocity(const WheelSpeeds& wheels, double wheel_base_m) {
  return {(wheels.right_m_s + wheels.left_m_s) / 2.0,
          (wheels.right_m_s - wheels.left_m_s) / wheel_base_m};
}

WheelSpeeds ToWheelSpeeds(const BodyVelocity& velocity, double wheel_base_m) {
  const double difference_m_s = velocity.angular_rad_s * wheel_base_m;
  return {velocity.linear_m_s - difference_m_s / 2.0, velocity.linear_m_s + difference_m_s / 2.0};
}

BodyVelocity Accelerate(const BodyVelocity& velocity, const BodyVelocity& wanted,
                        const AccelerationLimits& limits, double duration_s) {
  const double speed_change = limits.linear_m_s2 * duration_s;
  const double turn_rate_change = limits.angular_rad_s2 * duration_s;
  return {std::clamp(wanted.linear_m_s, velocity.linear_m_s - speed_change,
                     velocity.linear_m_s + speed_change),
          std::clamp(wanted.angular_rad_s, velocity.angular_rad_s - turn_rate_change,
                     velocity.angular_rad_s + turn_rate_change)};
}

backend::SE2 Drive(const backend::SE2& world_T_robot, const BodyVelocity& velocity,
                   double duration_s) {
  return world_T_robot *
         backend::Exp({velocity.linear_m_s * duration_s, 0.0, velocity.angular_rad_s * duration_s});
}

}  // namespace gmapping_spa::simulation
