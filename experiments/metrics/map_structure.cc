// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/map_structure.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "experiments/metrics/closing.h"
#include "experiments/metrics/harris_corners.h"
#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

constexpr double kMinCornerShare = 0.5;  // of the strength of a wide wall's corner
constexpr int kFrameCells = 3;           // reach of the closing and of the corner detector

using map::CellState;
using map::TrinaryMap;

int CountEnclosedAreas(const TrinaryMap& map) {
  std::vector<bool> visited(map.cells.size(), false);
  std::vector<std::pair<int, int>> frontier;
  const auto visit = [&](int column, int row) {
    const std::size_t cell = static_cast<std::size_t>(row) * map.width + column;
    if (visited[cell]) return;
    visited[cell] = true;
    frontier.emplace_back(column, row);
  };
  int areas = 0;
  for (int start_row = 0; start_row < map.height; ++start_row) {
    for (int start_column = 0; start_column < map.width; ++start_column) {
      const bool is_free = map.at(start_column, start_row) == CellState::kFree;
      if (!is_free || visited[static_cast<std::size_t>(start_row) * map.width + start_column]) {
        continue;
      }
      bool enclosed = true;
      visit(start_column, start_row);
      while (!frontier.empty()) {
        const auto [column, row] = frontier.back();
        frontier.pop_back();
        for (const auto& [x, y] : {std::pair(column + 1, row), std::pair(column - 1, row),
                                   std::pair(column, row + 1), std::pair(column, row - 1)}) {
          const CellState state = StateAt(map, x, y);
          if (state == CellState::kUnknown) enclosed = false;
          if (state == CellState::kFree) visit(x, y);
        }
      }
      areas += enclosed;
    }
  }
  return areas;
}

}  // namespace

MapStructure MeasureStructure(const TrinaryMap& map) {
  const TrinaryMap closed = Closed(Framed(map, kFrameCells), 1);
  return {.occupied_cells = static_cast<int>(
              std::count(map.cells.begin(), map.cells.end(), CellState::kOccupied)),
          .enclosed_areas = CountEnclosedAreas(closed),
          .corners = static_cast<int>(FindCorners(closed, kMinCornerShare).size())};
}

}  // namespace gmapping_spa::metrics
