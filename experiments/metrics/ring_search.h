// SPDX-License-Identifier: BSD-3-Clause
// The nearest of the things that the cells of a grid hold.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_RING_SEARCH_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_RING_SEARCH_H_

#include <Eigen/Core>
#include <algorithm>
#include <cstdlib>

#include "experiments/metrics/map_cells.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// The smallest distance_m(column, row) of all cells of the map, or cap_m when none is smaller.
// Searches in rings around the cell of `map_point`. distance_m must not be smaller than the
// distance from the point to the cell less `slack_m`.
template <typename DistanceOfCell>
double SearchRings(const map::TrinaryMap& map, const Eigen::Vector2d& map_point, double cap_m,
                   double slack_m, const DistanceOfCell& distance_m) {
  const Eigen::Vector2d center = ToCells(map, map_point);
  const int center_column = CellOf(center.x()), center_row = CellOf(center.y());
  double best_m = cap_m;
  for (int ring = 0; (ring - 1) * map.resolution_m - slack_m < best_m; ++ring) {
    const int first_row = std::max(center_row - ring, 0);
    const int last_row = std::min(center_row + ring, map.height - 1);
    for (int row = first_row; row <= last_row; ++row) {
      const bool whole_row = std::abs(row - center_row) == ring;
      const int step = whole_row || ring == 0 ? 1 : 2 * ring;
      for (int column = center_column - ring; column <= center_column + ring; column += step) {
        if (column < 0 || column >= map.width) continue;
        best_m = std::min(best_m, distance_m(column, row));
      }
    }
  }
  return best_m;
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_RING_SEARCH_H_
