// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/differential_drive.h"

namespace gmapping_spa::simulation {

BodyVelocity ToBodyVelocity(const WheelSpeeds& wheels, double wheel_base_m) {
  return {(wheels.right_m_s + wheels.left_m_s) / 2.0,
          (wheels.right_m_s - wheels.left_m_s) / wheel_base_m};
}

WheelSpeeds ToWheelSpeeds(const BodyVelocity& velocity, double wheel_base_m) {
  const double difference_m_s = velocity.angular_rad_s * wheel_base_m;
  return {velocity.linear_m_s - difference_m_s / 2.0, velocity.linear_m_s + difference_m_s / 2.0};
}

backend::SE2 Drive(const backend::SE2& world_T_robot, const BodyVelocity& velocity,
                   double duration_s) {
  return world_T_robot *
         backend::Exp({velocity.linear_m_s * duration_s, 0.0, velocity.angular_rad_s * duration_s});
}

}  // namespace gmapping_spa::simulation
