// SPDX-License-Identifier: BSD-3-Clause
// A raster of the occupied cells of a map in the frame of the true one.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_CELL_RASTER_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_CELL_RASTER_H_

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "experiments/metrics/map_cells.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// The smallest map, of the grid with a corner at `corner` and cells of resolution_m, whose cells
// hold all points; those that hold one are occupied, the others unknown.
inline map::TrinaryMap Rasterize(const std::vector<Eigen::Vector2d>& points,
                                 const Eigen::Vector2d& corner, double resolution_m) {
  map::TrinaryMap raster{1, 1, resolution_m, corner.x(), corner.y(), {}};
  if (points.empty()) {
    raster.cells.assign(1, map::CellState::kUnknown);
    return raster;
  }
  Eigen::Vector2d low = points.front(), high = points.front();
  for (const Eigen::Vector2d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Vector2d first = ToCells(raster, low).array().floor();
  const Eigen::Vector2d last = ToCells(raster, high).array().floor();
  raster.origin_x_m += first.x() * resolution_m;
  raster.origin_y_m += first.y() * resolution_m;
  raster.width = static_cast<int>(last.x() - first.x()) + 1;
  raster.height = static_cast<int>(last.y() - first.y()) + 1;
  raster.cells.assign(static_cast<std::size_t>(raster.width) * raster.height,
                      map::CellState::kUnknown);
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d cell = ToCells(raster, point);
    // Rounding must not lead out of the raster.
    raster.at(std::clamp(CellOf(cell.x()), 0, raster.width - 1),
              std::clamp(CellOf(cell.y()), 0, raster.height - 1)) = map::CellState::kOccupied;
  }
  return raster;
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_CELL_RASTER_H_
