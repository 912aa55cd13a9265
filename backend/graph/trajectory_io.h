// SPDX-License-Identifier: BSD-3-Clause
// Trajectories in the TUM format: "stamp x y z qx qy qz qw", one pose a line.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_TRAJECTORY_IO_H_
#define GMAPPING_SPA_BACKEND_GRAPH_TRAJECTORY_IO_H_

#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include "backend/se2.h"

namespace gmapping_spa::backend {

struct StampedPose {
  double stamp_s = 0.0;
  SE2 world_T_robot;
};
using Trajectory = std::vector<StampedPose>;

// Reads a trajectory in file order, skipping blank lines and '#' comments. Of the position x and y
// are kept, of the rotation the yaw (roll and pitch are applied before it). `name` is for messages.
// Throws std::runtime_error "<name>:<line>: expected <what>, found <what>" on another number of
// columns, a number that is not finite, or a quaternion whose norm is off 1 by more than 0.01.
Trajectory ReadTum(std::istream& in, const std::string& name);

// Writes every number with as many digits as it takes to read back the same value, angles in
// [-pi, pi] included. Throws std::invalid_argument when a stamp or pose is not finite.
void WriteTum(const Trajectory& trajectory, std::ostream& out);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_TRAJECTORY_IO_H_
