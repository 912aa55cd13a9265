// SPDX-License-Identifier: BSD-3-Clause
// A finished map: every cell free, occupied or unknown.
#ifndef GMAPPING_SPA_FRONTEND_MAP_TRINARY_MAP_H_
#define GMAPPING_SPA_FRONTEND_MAP_TRINARY_MAP_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gmapping_spa::map {

enum class CellState : std::uint8_t { kUnknown, kFree, kOccupied };

// Row-major, row 0 at the bottom (smallest y). Cell (column, row) covers
// [origin_x_m + column * resolution_m, + resolution_m) in x and likewise in y, in the world frame.
struct TrinaryMap {
  int width = 0;   // columns
  int height = 0;  // rows
  double resolution_m = 0.05;
  double origin_x_m = 0.0;  // world coordinates of the lower left corner
  double origin_y_m = 0.0;
  std::vector<CellState> cells;  // width * height

  CellState at(int column, int row) const {
    return cells[static_cast<std::size_t>(row) * width + column];
  }
  CellState& at(int column, int row) {
    return cells[static_cast<std::size_t>(row) * width + column];
  }
};

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_TRINARY_MAP_H_
