// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map_area.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "frontend/map/map_server_io.h"
#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::frontend {

void MapArea::Extend(const sensor::LaserScan& scan, const backend::SE2& world_T_robot) {
  double reach_m = 0.0;
  for (const sensor::Beam& beam : scan.beams) reach_m = std::max(reach_m, beam.range_m);
  area_.extend(world_T_robot.translation() - Eigen::Vector2d::Constant(reach_m));
  area_.extend(world_T_robot.translation() + Eigen::Vector2d::Constant(reach_m));
  const Eigen::Vector2d cells = area_.sizes() / resolution_m_;
  // The world's origin is somewhere inside. Negated, so that NaN fails.
  constexpr int kMostAcross = map::kMaxCellIndex / 2;
  if (!world_T_robot.IsFinite() ||
      !(cells.prod() < map::kMaxMapCells && cells.maxCoeff() < kMostAcross)) {
    throw std::runtime_error("scan " + std::to_string(scan.index) +
                             ": the odometry leads out of the area that a map can cover (" +
                             std::to_string(map::kMaxMapCells) + " cells)");
  }
}

}  // namespace gmapping_spa::frontend
