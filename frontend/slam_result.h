// SPDX-License-Identifier: BSD-3-Clause
// What SLAM is after.
#ifndef GMAPPING_SPA_FRONTEND_SLAM_RESULT_H_
#define GMAPPING_SPA_FRONTEND_SLAM_RESULT_H_

#include "backend/graph/pose_graph.h"
#include "backend/graph/trajectory_io.h"
#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::frontend {

struct SlamResult {
  backend::PoseGraph graph;        // a node for every update of the filter
  backend::Trajectory trajectory;  // poses of all scans in the order of the input
  map::OccupancyGrid map;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_SLAM_RESULT_H_
