// SPDX-License-Identifier: BSD-3-Clause
// Where points of a map's frame lie among its cells.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_CELLS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_CELLS_H_

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// The neighbors of a cell across its four sides, as steps in columns and rows.
inline constexpr std::array<std::array<int, 2>, 4> kSides = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

// In units of cells, from the lower left corner of the map.
inline Eigen::Vector2d ToCells(const map::TrinaryMap& map, const Eigen::Vector2d& point) {
  return (point - Eigen::Vector2d(map.origin_x_m, map.origin_y_m)) / map.resolution_m;
}

// The column or row of such a coordinate. Clamped far away from any map, where int still holds it.
inline int CellOf(double cells) {
  constexpr double kFarAway = 1e9;
  return static_cast<int>(std::floor(std::clamp(cells, -kFarAway, kFarAway)));
}

inline Eigen::Vector2d CellCenter(const map::TrinaryMap& map, int column, int row) {
  return {map.origin_x_m + (column + 0.5) * map.resolution_m,
          map.origin_y_m + (row + 0.5) * map.resolution_m};
}

// Row by row.
inline std::vector<Eigen::Vector2d> OccupiedCenters(const map::TrinaryMap& map) {
  std::vector<Eigen::Vector2d> centers;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) == map::CellState::kOccupied) {
        centers.push_back(CellCenter(map, column, row));
      }
    }
  }
  return centers;
}

// Around the map, everything is unknown.
inline map::CellState StateAt(const map::TrinaryMap& map, int column, int row) {
  const bool inside = column >= 0 && column < map.width && row >= 0 && row < map.height;
  return inside ? map.at(column, row) : map::CellState::kUnknown;
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_CELLS_H_
