// SPDX-License-Identifier: BSD-3-Clause
// The cells of a grid that a ray passes through.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_GRID_RAY_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_GRID_RAY_H_

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {

// Calls visit(column, row, begin, end) for each cell along the ray, in order, until it returns
// false or `length` is reached; begin and end are where the ray enters and leaves the cell. All in
// units of cells, from the lower left corner of the grid, which has no bounds here. `direction` is
// a unit vector. A ray along an edge or through a corner may visit cells in which it has no length.
// Amanatides and Woo, "A fast voxel traversal algorithm for ray tracing", Eurographics 1987.
template <typename Visit>
void VisitCellsAlong(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double length,
                     const Visit& visit) {
  // A ray along one axis never crosses an edge of the other.
  constexpr double kNever = std::numeric_limits<double>::infinity();
  int column = CellOf(origin.x()), row = CellOf(origin.y());
  const int step_x = direction.x() > 0.0 ? 1 : -1, step_y = direction.y() > 0.0 ? 1 : -1;
  const double per_dx = 1.0 / direction.x(), per_dy = 1.0 / direction.y();
  // Computed anew for each cell, so that rounding errors do not add up.
  const auto crossing_x = [&] {
    return direction.x() == 0.0 ? kNever : (column + (step_x > 0) - origin.x()) * per_dx;
  };
  const auto crossing_y = [&] {
    return direction.y() == 0.0 ? kNever : (row + (step_y > 0) - origin.y()) * per_dy;
  };
  double begin = 0.0, next_x = crossing_x(), next_y = crossing_y();
  while (begin < length) {
    const double end = std::min({next_x, next_y, length});
    if (!visit(column, row, begin, end)) return;
    begin = end;
    if (next_x < next_y) {
      column += step_x;
      next_x = crossing_x();
    } else {
      row += step_y;
      next_y = crossing_y();
    }
  }
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_GRID_RAY_H_
