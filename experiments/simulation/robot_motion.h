// SPDX-License-Identifier: BSD-3-Clause
// How a robot moves along its tours, whatever its sensors say.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_ROBOT_MOTION_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_ROBOT_MOTION_H_

#include <vector>

#include "backend/se2.h"
#include "experiments/simulation/differential_drive.h"
#include "experiments/simulation/way_point_follower.h"

namespace gmapping_spa::simulation {

struct MotionStep {
  double time_s = 0.0;
  backend::SE2 world_T_robot;  // at that time
  BodyVelocity before, after;  // up to it, and from it on
  bool carried = false;        // off the ground: its pose is that where it was picked up
};

// One step each 1 / steps_per_s from time 0 on, up to the end of the last tour. Between two tours
// the robot is carried for `carry_s`, at least a step, to the start of the next.
// Throws std::runtime_error with one line when the robot does not reach a way point.
std::vector<MotionStep> DriveTours(const std::vector<WayPoints>& tours,
                                   const WayPointFollowerOptions& options, double steps_per_s,
                                   double carry_s);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_ROBOT_MOTION_H_
