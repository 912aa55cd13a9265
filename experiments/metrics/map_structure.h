// SPDX-License-Identifier: BSD-3-Clause
// What a map without truth says about its own quality, after Filatov et al., "2D SLAM quality
// evaluation methods", FRUCT 2017: errors make corners, enclosed areas and occupied cells that the
// world does not have, so of two maps of the same scans that with fewer is better.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_STRUCTURE_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_STRUCTURE_H_

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// Corners and areas are counted once the occupied cells are closed with a square of 3 x 3 cells,
// which fills holes and gaps of one or two cells.
struct MapStructure {
  int occupied_cells = 0;  // as they are
  int enclosed_areas = 0;
  int corners = 0;
};

// An enclosed area is a set of free cells, connected by edges, that touches (by edges) occupied
// cells only: no unknown ones and not the edge of the map.
// Corners are those of harris_corners.h with half the strength of a wide wall's or more.
MapStructure MeasureStructure(const map::TrinaryMap& map);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_STRUCTURE_H_
