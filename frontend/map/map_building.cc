// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/map_building.h"

#include "backend/out_of_memory.h"

#include <algorithm>

namespace gmapping_spa::map {
namespace {

// Extent of the known cells themselves; KnownExtent() knows whole tiles only.
OccupancyGrid::Extent TightExtent(const OccupancyGrid& grid) {
  const OccupancyGrid::Extent tiles = grid.KnownExtent();
  OccupancyGrid::Extent tight{tiles.max, tiles.min};
  for (int y = tiles.min.y; y < tiles.max.y; ++y) {
    for (int x = tiles.min.x; x < tiles.max.x; ++x) {
      if (grid.cell({x, y}).visits == 0) continue;
      tight.min = {std::min(tight.min.x, x), std::min(tight.min.y, y)};
      tight.max = {std::max(tight.max.x, x + 1), std::max(tight.max.y, y + 1)};
    }
  }
  return tight;
}

}  // namespace

TrinaryMap BuildTrinaryMap(const OccupancyGrid& grid, double occupied_threshold) {
  const OccupancyGrid::Extent extent = TightExtent(grid);
  TrinaryMap map;
  map.width = extent.max.x - extent.min.x;
  map.height = extent.max.y - extent.min.y;
  map.resolution_m = grid.resolution_m();
  map.origin_x_m = extent.min.x * map.resolution_m;
  map.origin_y_m = extent.min.y * map.resolution_m;
  backend::WithMemory(
      "while drawing the map: " + backend::MemoryOfCells(map.width, map.height, 1), [&] {
        map.cells.resize(static_cast<std::size_t>(map.width) * map.height, CellState::kUnknown);
      });
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Cell& cell = grid.cell({extent.min.x + column, extent.min.y + row});
      if (cell.visits == 0) continue;
      map.at(column, row) =
          cell.hits > occupied_threshold * cell.visits ? CellState::kOccupied : CellState::kFree;
    }
  }
  return map;
}

}  // namespace gmapping_spa::map
