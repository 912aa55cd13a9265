// SPDX-License-Identifier: BSD-3-Clause
// Morphological dilation and closing of a map's occupied cells.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_CLOSING_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_CLOSING_H_

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// The map in a frame of so many unknown cells: maps end at their outermost walls, which are to be
// treated as all others. Points keep their coordinates.
map::TrinaryMap Framed(const map::TrinaryMap& map, int frame_cells);

// Occupied where any of the 3 x 3 cells around is.
map::TrinaryMap Dilated(const map::TrinaryMap& map);

// Dilates, then erodes the occupied cells `cells` times with a square of 3 x 3 cells: fills holes
// and gaps that are up to twice as many cells wide. Needs a frame of as many cells, for at the edge
// of the map all stays as it is outside of it.
map::TrinaryMap Closed(const map::TrinaryMap& map, int cells);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_CLOSING_H_
