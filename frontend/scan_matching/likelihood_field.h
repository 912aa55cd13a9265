// SPDX-License-Identifier: BSD-3-Clause
// How near each cell of a grid is to the points of a reference scan or map, as bytes.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_LIKELIHOOD_FIELD_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_LIKELIHOOD_FIELD_H_

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::scan_matching {

// A dense rectangle of bytes in a plane of zeros. The last column and the last row are always zero:
// whatever lies outside, on any side, is looked up there without a branch.
struct ByteGrid {
  map::CellIndex min;                   // the first cell
  unsigned columns = 1;                 // the zeros included
  unsigned rows = 1;                    // the zeros included
  std::vector<std::uint8_t> values{0};  // row by row

  // Position of a cell of the plane in a row or in a column.
  unsigned Column(int x) const {
    return std::min(static_cast<unsigned>(x) - static_cast<unsigned>(min.x), columns - 1);
  }
  unsigned Row(int y) const {
    return std::min(static_cast<unsigned>(y) - static_cast<unsigned>(min.y), rows - 1);
  }
  const std::uint8_t* RowValues(unsigned row) const {
    return values.data() + static_cast<std::size_t>(row) * columns;
  }
  std::uint8_t* RowValues(unsigned row) {
    return values.data() + static_cast<std::size_t>(row) * columns;
  }
  std::uint8_t value(map::CellIndex cell) const { return RowValues(Row(cell.y))[Column(cell.x)]; }
};

struct LikelihoodFieldOptions {
  double resolution_m = 0.05;
  double sigma_m = 0.1;  // of the distance between a point and what it is matched with
  friend bool operator==(const LikelihoodFieldOptions&, const LikelihoodFieldOptions&) = default;
};

// 255 exp(-d^2 / 2 sigma^2) at each cell, rounded, where d is the distance from the middle of the
// cell to the nearest of `points` (in metres, in the frame of the map). Memory grows with the
// bounding box of the points. Precondition: they are finite and less than kMaxCellIndex away.
ByteGrid MakeLikelihoodField(const LikelihoodFieldOptions& options,
                             const std::vector<Eigen::Vector2d>& points);

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_LIKELIHOOD_FIELD_H_
