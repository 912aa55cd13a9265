// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/closing.h"

#include <algorithm>
#include <cstddef>

#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

bool IsOccupied(const TrinaryMap& map, int column, int row) {
  return StateAt(map, column, row) == CellState::kOccupied;
}

// No longer occupied where any of the 3 x 3 cells around is not; then as `before`.
TrinaryMap Eroded(const TrinaryMap& map, const TrinaryMap& before) {
  TrinaryMap eroded = map;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      bool all = true;
      for (int y = row - 1; all && y <= row + 1; ++y) {
        for (int x = column - 1; all && x <= column + 1; ++x) all = IsOccupied(map, x, y);
      }
      if (!all) eroded.at(column, row) = before.at(column, row);
    }
  }
  return eroded;
}

}  // namespace

TrinaryMap Framed(const TrinaryMap& map, int frame_cells) {
  TrinaryMap framed = map;
  framed.width += 2 * frame_cells;
  framed.height += 2 * frame_cells;
  framed.origin_x_m -= frame_cells * map.resolution_m;
  framed.origin_y_m -= frame_cells * map.resolution_m;
  framed.cells.assign(static_cast<std::size_t>(framed.width) * framed.height, CellState::kUnknown);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      framed.at(column + frame_cells, row + frame_cells) = map.at(column, row);
    }
  }
  return framed;
}

TrinaryMap Dilated(const TrinaryMap& map) {
  TrinaryMap dilated = map;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) != CellState::kOccupied) continue;
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, map.height - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, map.width - 1); ++x) {
          dilated.at(x, y) = CellState::kOccupied;
        }
      }
    }
  }
  return dilated;
}

TrinaryMap Closed(const TrinaryMap& map, int cells) {
  TrinaryMap closed = map;
  for (int i = 0; i < cells; ++i) closed = Dilated(closed);
  TrinaryMap freed = map;  // what is no longer occupied
  for (CellState& state : freed.cells) {
    if (state == CellState::kOccupied) state = CellState::kUnknown;
  }
  for (int i = 0; i < cells; ++i) closed = Eroded(closed, freed);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (map.cells[i] == CellState::kOccupied) closed.cells[i] = CellState::kOccupied;
  }
  return closed;
}

}  // namespace gmapping_spa::metrics
