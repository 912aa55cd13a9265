// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/field_pyramid.h"

#include <glog/logging.h>

#include <utility>

namespace gmapping_spa::scan_matching {

namespace {

void RaiseTo(const std::uint8_t* values, std::size_t count, std::uint8_t* target) {
  for (std::size_t i = 0; i < count; ++i) target[i] = std::max(target[i], values[i]);
}

// At each cell the maximum of `grid` there, `shift` cells to the right, above, and both.
ByteGrid MaxOfShifted(const ByteGrid& grid, int shift) {
  const auto up = static_cast<unsigned>(shift);
  ByteGrid result;
  result.min = {grid.min.x - shift, grid.min.y - shift};
  result.columns = grid.columns + up;
  result.rows = grid.rows + up;
  // Appended row by row: clearing a large grid before it is written costs as much as all the rest.
  result.values.clear();
  result.values.reserve(static_cast<std::size_t>(result.columns) * result.rows);
  std::vector<std::uint8_t> row_max(result.columns);
  for (unsigned row = 0; row < result.rows; ++row) {
    std::fill(row_max.begin(), row_max.end(), std::uint8_t{0});
    if (row < grid.rows) {
      RaiseTo(grid.RowValues(row), grid.columns, row_max.data());
      RaiseTo(grid.RowValues(row), grid.columns, row_max.data() + shift);
    }
    result.values.insert(result.values.end(), row_max.begin(), row_max.end());
  }
  // From above, so that the row below has not been raised yet.
  for (unsigned row = result.rows - 1; row >= up; --row) {
    RaiseTo(result.RowValues(row - up), result.columns, result.RowValues(row));
  }
  return result;
}

}  // namespace

FieldPyramid::FieldPyramid(ByteGrid field, int levels) {
  CHECK_GE(levels, 1);
  CHECK_LE(levels, 16);
  levels_.reserve(static_cast<std::size_t>(levels));
  levels_.push_back(std::move(field));
  for (int h = 1; h < levels; ++h) {
    // Squares put side by side make one of twice the width; but from level 0 to level 1, the first
    // with a reach, it is four times the width.
    const int reach_before = Reach(h - 1), reach = Reach(h);
    ByteGrid next = MaxOfShifted(levels_.back(), (1 << (h - 1)) + 2 * reach_before);
    if (h == 1) next = MaxOfShifted(next, 2);
    // So far the square of a cell begins reach_before to the left of it, and below.
    next.min.x += reach - reach_before;
    next.min.y += reach - reach_before;
    levels_.push_back(std::move(next));
  }
}

}  // namespace gmapping_spa::scan_matching
