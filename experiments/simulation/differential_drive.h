// SPDX-License-Identifier: BSD-3-Clause
// Kinematics of a differential-drive robot, eqs. 1 to 3 of the paper.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_DIFFERENTIAL_DRIVE_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_DIFFERENTIAL_DRIVE_H_

#include "backend/se2.h"

namespace gmapping_spa::simulation {

struct WheelSpeeds {
  double left_m_s = 0.0;
  double right_m_s = 0.0;
};

// In the robot frame: forward along x, counter-clockwise about its center.
struct BodyVelocity {
  double linear_m_s = 0.0;
  double angular_rad_s = 0.0;
};

// v = (v_r + v_l) / 2, omega = (v_r - v_l) / wheel_base.
BodyVelocity ToBodyVelocity(const WheelSpeeds& wheels, double wheel_base_m);

// Inverse of ToBodyVelocity.
WheelSpeeds ToWheelSpeeds(const BodyVelocity& velocity, double wheel_base_m);

struct AccelerationLimits {
  double linear_m_s2 = 1.0;
  double angular_rad_s2 = 2.0;
};

// From `velocity` as near to `wanted` as the limits allow within a while.
BodyVelocity Accelerate(const BodyVelocity& velocity, const BodyVelocity& wanted,
                        const AccelerationLimits& limits, double duration_s);

// The pose after driving for a while at constant velocity: the exact integral, a circular arc, of
//   x' = v cos(theta), y' = v sin(theta), theta' = omega.                                      (1)
backend::SE2 Drive(const backend::SE2& world_T_robot, const BodyVelocity& velocity,
                   double duration_s);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_DIFFERENTIAL_DRIVE_H_
