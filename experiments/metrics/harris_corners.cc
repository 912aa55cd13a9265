// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/harris_corners.h"

#include <algorithm>
#include <cstddef>

#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

// Harris' measure of every cell, from the image that is 1 where the map is occupied.
std::vector<double> CornerStrength(const TrinaryMap& map) {
  struct Products {
    double xx = 0.0, xy = 0.0, yy = 0.0;
  };
  std::vector<Products> products(map.cells.size());
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const auto at = [&](int x, int y) {
        return StateAt(map, column + x, row + y) == CellState::kOccupied ? 1.0 : 0.0;
      };
      const double dx =
          at(1, -1) + 2 * at(1, 0) + at(1, 1) - at(-1, -1) - 2 * at(-1, 0) - at(-1, 1);
      const double dy =
          at(-1, 1) + 2 * at(0, 1) + at(1, 1) - at(-1, -1) - 2 * at(0, -1) - at(1, -1);
      products[static_cast<std::size_t>(row) * map.width + column] = {dx * dx, dx * dy, dy * dy};
    }
  }
  std::vector<double> strength(map.cells.size(), 0.0);
  for (int row = 2; row + 2 < map.height; ++row) {
    for (int column = 2; column + 2 < map.width; ++column) {
      Products sum;
      for (int y = row - 2; y <= row + 2; ++y) {
        for (int x = column - 2; x <= column + 2; ++x) {
          const Products& p = products[static_cast<std::size_t>(y) * map.width + x];
          sum.xx += p.xx, sum.xy += p.xy, sum.yy += p.yy;
        }
      }
      const double trace = sum.xx + sum.yy;
      strength[static_cast<std::size_t>(row) * map.width + column] =
          sum.xx * sum.yy - sum.xy * sum.xy - 0.04 * trace * trace;
    }
  }
  return strength;
}

}  // namespace

std::vector<Eigen::Vector2d> FindCorners(const TrinaryMap& map, double min_share) {
  const double min_strength = min_share * 11047.0;  // that of the corner of a wide wall
  constexpr int kRadius = 3;
  const std::vector<double> strength = CornerStrength(map);
  std::vector<Eigen::Vector2d> corners;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const std::size_t cell = static_cast<std::size_t>(row) * map.width + column;
      bool is_corner = strength[cell] > min_strength;
      for (int y = std::max(row - kRadius, 0);
           is_corner && y <= std::min(row + kRadius, map.height - 1); ++y) {
        for (int x = std::max(column - kRadius, 0); x <= std::min(column + kRadius, map.width - 1);
             ++x) {
          const std::size_t other = static_cast<std::size_t>(y) * map.width + x;
          // Of equal ones the first counts.
          if (strength[other] > strength[cell] ||
              (strength[other] == strength[cell] && other < cell)) {
            is_corner = false;
          }
        }
      }
      if (is_corner) corners.push_back(CellCenter(map, column, row));
    }
  }
  return corners;
}

}  // namespace gmapping_spa::metrics
