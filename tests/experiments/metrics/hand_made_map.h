// SPDX-License-Identifier: BSD-3-Clause
// Maps drawn by hand.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_METRICS_HAND_MADE_MAP_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_METRICS_HAND_MADE_MAP_H_

#include <cstddef>
#include <string>
#include <vector>

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// All cells unknown, 0.05 m wide, the lower left corner at the origin.
inline map::TrinaryMap UnknownMap(int width, int height) {
  map::TrinaryMap map{width, height, 0.05, 0.0, 0.0, {}};
  map.cells.assign(static_cast<std::size_t>(width) * height, map::CellState::kUnknown);
  return map;
}

// '#' occupied, '.' free, ' ' unknown; the first line is the top row, all are equally long.
inline map::TrinaryMap DrawnMap(const std::vector<std::string>& lines) {
  map::TrinaryMap map =
      UnknownMap(static_cast<int>(lines[0].size()), static_cast<int>(lines.size()));
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const char cell = lines[map.height - 1 - row][column];
      if (cell != ' ') {
        map.at(column, row) = cell == '#' ? map::CellState::kOccupied : map::CellState::kFree;
      }
    }
  }
  return map;
}

// Columns and rows [left, right) x [bottom, top).
inline void Fill(int left, int bottom, int right, int top, map::CellState state,
                 map::TrinaryMap* map) {
  for (int row = bottom; row < top; ++row) {
    for (int column = left; column < right; ++column) map->at(column, row) = state;
  }
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_METRICS_HAND_MADE_MAP_H_
