// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/seen_through.h"

#include <Eigen/Geometry>

namespace gmapping_spa::scan_matching {

namespace {

// What is hit so near to the end of a beam is what the beam has hit, seen at a flat angle or from a
// pose that is a little off; and a laser sees nothing so near to itself.
constexpr double kMargin_m = 0.3;

map::CellIndex CellAt(const Eigen::Vector2d& in_cells) {
  return {map::FloorToCell(in_cells.x()), map::FloorToCell(in_cells.y())};
}

}  // namespace

SeenThrough CountSeenThrough(const map::OccupancyGrid& grid, const ScanPoints& points,
                             const backend::SE2& world_T_robot) {
  const double cells_per_m = 1.0 / grid.resolution_m();
  const double margin = kMargin_m * cells_per_m;
  SeenThrough through;
  const Eigen::Rotation2Dd rotation(world_T_robot.theta);
  for (const ScanPoint& point : points) {
    const Eigen::Vector2d end = world_T_robot * Eigen::Vector2d(point.x_m, point.y_m) * cells_per_m;
    const Eigen::Vector2d back = rotation * Eigen::Vector2d(point.back_x, point.back_y);
    for (double k = margin; k < point.range_m * cells_per_m - margin; ++k) {
      if (grid.OccupiedBits(CellAt(end + k * back)) & 1u) {
        through.all += point.weight;
        if (grid.cell(CellAt(end)).visits == 0) through.into_unseen += point.weight;
        break;
      }
    }
  }
  return through;
}

}  // namespace gmapping_spa::scan_matching
