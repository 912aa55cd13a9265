// Trajectories in the TUM format: "stamp x y z qx qy qz qw", one pose a line.
#ifndef GMAPPING_SPA_BACKEND_TRAJECTORY_IO_H_
#define GMAPPING_SPA_BACKEND_TRAJECTORY_IO_H_

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

// Reads a trajectory in file order, skipping blank lines and '#' comments. `name` is for messages.
// Throws std::runtime_error "<name>:<line>: <what was expected>" on anything else.
Trajectory ReadTum(std::istream& in, const std::string& name);

// Writes stamps with 6 and poses with 17 significant digits where needed to read back the same
// value.
void WriteTum(const Trajectory& trajectory, std::ostream& out);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_TRAJECTORY_IO_H_
