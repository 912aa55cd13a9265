// SPDX-License-Identifier: BSD-3-Clause
// Beams that contradict a map in the one way that nothing in front of the laser can.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SEEN_THROUGH_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SEEN_THROUGH_H_

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

// Numbers of beams that pass through occupied cells of a map and end more than 0.3 m behind them,
// each counted by its ScanPoint::weight. Whoever stands in front of a laser makes beams shorter,
// never longer.
struct SeenThrough {
  double all = 0.0;
  double into_unseen = 0.0;  // of these, the beams that end where no beam has been
};

// `points`: of a scan, in the robot frame. `world_T_robot`: a pose of the robot in the map's frame.
SeenThrough CountSeenThrough(const map::OccupancyGrid& grid, const ScanPoints& points,
                             const backend::SE2& world_T_robot);

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SEEN_THROUGH_H_
