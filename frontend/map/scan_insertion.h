// SPDX-License-Identifier: BSD-3-Clause
// Entering a scan into an occupancy grid.
#ifndef GMAPPING_SPA_FRONTEND_MAP_SCAN_INSERTION_H_
#define GMAPPING_SPA_FRONTEND_MAP_SCAN_INSERTION_H_

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::map {

struct InsertionOptions {
  // Whether a beam without return counts as free space up to the usable range. Off by default: on
  // many scanners a missing return also means glass, black or grazing surfaces.
  bool no_return_clears = false;
  // A hit does not clear so much of the beam before it: a beam that grazes a wall passes through
  // cells of that wall.
  double clear_margin_m = 0.0;
  friend bool operator==(const InsertionOptions&, const InsertionOptions&) = default;
};

// Eq. (15), integrateScan: the map posterior given a pose. Every hit counts for the cell that holds
// its end point and as a pass for the cells on the way there.
void InsertScan(const sensor::LaserScan& scan, const backend::SE2& world_T_robot,
                const InsertionOptions& options, OccupancyGrid* grid);

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_SCAN_INSERTION_H_
