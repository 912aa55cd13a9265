// SPDX-License-Identifier: BSD-3-Clause
// Sets of occupied cells that hang together.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_CONNECTED_CELLS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_CONNECTED_CELLS_H_

#include <array>
#include <cstddef>
#include <vector>

#include "experiments/metrics/map_cells.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// Columns and rows of the occupied cells that share edges or corners, set by set, in the order of
// the first cell of each by rows and columns.
inline std::vector<std::vector<std::array<int, 2>>> ConnectedCells(const map::TrinaryMap& map) {
  std::vector<std::vector<std::array<int, 2>>> sets;
  std::vector<bool> reached(map.cells.size(), false);
  std::vector<std::array<int, 2>> frontier;
  const auto reach = [&](int column, int row) {
    if (StateAt(map, column, row) != map::CellState::kOccupied) return;
    auto cell = reached[static_cast<std::size_t>(row) * map.width + column];
    if (!cell) frontier.push_back({column, row});
    cell = true;
  };
  for (int start_row = 0; start_row < map.height; ++start_row) {
    for (int start_column = 0; start_column < map.width; ++start_column) {
      reach(start_column, start_row);
      if (frontier.empty()) continue;
      auto& set = sets.emplace_back();
      while (!frontier.empty()) {
        const auto [column, row] = frontier.back();
        frontier.pop_back();
        set.push_back({column, row});
        for (int y = row - 1; y <= row + 1; ++y) {
          for (int x = column - 1; x <= column + 1; ++x) reach(x, y);
        }
      }
    }
  }
  return sets;
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_CONNECTED_CELLS_H_
