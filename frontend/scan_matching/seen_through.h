// Beams that contradict a map in the one way that nothing in front of the laser can.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SEEN_THROUGH_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SEEN_THROUGH_H_

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

// Number of beams, each with its ScanPoint::weight, that pass through full cells of the map and end
// farther away. Whoever stands in front of a laser makes beams shorter, never longer.
struct SeenThrough {
  double all = 0.0;
  double into_unseen = 0.0;  // of these, the beams that end where no beam has been
};

SeenThrough CountSeenThrough(const map::OccupancyGrid& grid, const ScanPoints& points,
                             const backend::SE2& world_T_robot);

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SEEN_THROUGH_H_
