// SPDX-License-Identifier: BSD-3-Clause
// Trajectories in the format of the KITTI odometry benchmark: a pose a line as the 12 numbers of a
// 3x4 matrix [R t], row by row, without stamps; and the times of its times.txt, one a line.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_KITTI_IO_H_
#define GMAPPING_SPA_BACKEND_GRAPH_KITTI_IO_H_

#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include "backend/graph/trajectory_io.h"
#include "backend/se2.h"

namespace gmapping_spa::backend {

// Reads poses in file order, skipping blank lines and '#' comments. Of the position x and y are
// kept, of the rotation the yaw: z points up, as WriteKitti has it, and not forward as in the
// benchmark's own files, which are poses of a camera. `name` is for messages. Throws
// std::runtime_error "<name>:<line>: expected <what>, found <what>" on another number of columns, a
// number that is not finite, a matrix that is no rotation to 0.01, or a z axis that is more than 45
// degrees off the vertical.
std::vector<SE2> ReadKitti(std::istream& in, const std::string& name);

// Writes the matrices world_T_robot, z up, numbers with as many digits as it takes to read back the
// same value. Throws std::invalid_argument when a pose is not finite.
void WriteKitti(const Trajectory& trajectory, std::ostream& out);

// Writes the stamps of the poses, in s, a line each. Throws std::invalid_argument when one is not
// finite.
void WriteTimes(const Trajectory& trajectory, std::ostream& out);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_KITTI_IO_H_
