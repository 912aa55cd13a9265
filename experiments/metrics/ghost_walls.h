// SPDX-License-Identifier: BSD-3-Clause
// Walls that a map draws where there are none.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_GHOST_WALLS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_GHOST_WALLS_H_

#include <Eigen/Core>
#include <vector>

#include "experiments/metrics/map_comparison.h"

namespace gmapping_spa::metrics {

// A line of occupied cells, of kMinWall_m or more, with all its branches.
struct GhostWall {
  double length_m = 0.0;                // of all branches
  std::vector<Eigen::Vector2d> points;  // its cells, in the frame of the true map
};

// Lines of the occupied cells that are farther than the tolerance from every true surface, in sight
// or not, and belong to no wall that is merely shifted, that is to the first band across an element
// of surface. They are closed with 3 x 3 cells (the larger ones of the two maps), so that holes of
// one or two cells do not part a wall, and thinned, so that a thick wall counts once.
std::vector<GhostWall> FindGhostWalls(const MapComparison& comparison, double tolerance_m);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_GHOST_WALLS_H_
