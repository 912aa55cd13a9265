// SPDX-License-Identifier: BSD-3-Clause
// From an occupancy grid to a finished map.
#ifndef GMAPPING_SPA_FRONTEND_MAP_MAP_BUILDING_H_
#define GMAPPING_SPA_FRONTEND_MAP_MAP_BUILDING_H_

#include "frontend/map/occupancy_grid.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::map {

// Decides every cell: unknown where no beam has been, occupied where more than `occupied_threshold`
// of the beams that met it ended there (0.25 is GMapping's default), free otherwise. The result is
// the smallest rectangle that holds all known cells; a grid without any gives a map of 0 x 0.
TrinaryMap BuildTrinaryMap(const OccupancyGrid& grid, double occupied_threshold);

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_MAP_BUILDING_H_
