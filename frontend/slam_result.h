// SPDX-License-Identifier: BSD-3-Clause
// What SLAM is after.
#ifndef GMAPPING_SPA_FRONTEND_SLAM_RESULT_H_
#define GMAPPING_SPA_FRONTEND_SLAM_RESULT_H_

#include <vector>

#include "backend/graph/pose_graph.h"
#include "backend/graph/trajectory_io.h"
#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::frontend {

struct SlamResult {
  backend::PoseGraph graph;        // a node for every update of the filter
  backend::Trajectory trajectory;  // poses of all scans in the order of the input
  map::OccupancyGrid map;
  // Of each row of the trajectory whether it is known where in the map the robot was: it was not
  // lost, or in a piece that was never joined with the map.
  std::vector<bool> is_placed;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_SLAM_RESULT_H_
