// SPDX-License-Identifier: BSD-3-Clause
// A small part of an occupancy grid, copied out for a search that stays near one place.
#ifndef GMAPPING_SPA_FRONTEND_MAP_CELL_BLOCK_H_
#define GMAPPING_SPA_FRONTEND_MAP_CELL_BLOCK_H_

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::map {

// 8 x 8 cells: which of them are occupied, as the bits of one word, and the hit means of those.
// Asking the grid itself costs several times as much, and a scan matcher asks for the same cells
// again and again.
class CellBlock {
 public:
  // Covers nothing. The hit means are left as they are: a matcher makes hundreds of blocks.
  CellBlock() {}  // NOLINT

  // Copies the block around `center`.
  void CopyFrom(const OccupancyGrid& grid, CellIndex center) {
    corner_ = {center.x - kCentre, center.y - kCentre};
    occupied_ = 0;
    often_hit_ = 0;
    for (int row = 0; row < kSize; ++row) {
      const std::uint64_t bits = grid.OccupiedBits({corner_.x, corner_.y + row});
      occupied_ |= bits << (kSize * row);
    }
    x_.fill(kFarAway);
    y_.fill(kFarAway);
    for (std::uint64_t rest = occupied_; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      const int column = bit % kSize, row = bit / kSize;
      const Cell& cell = grid.cell({corner_.x + column, corner_.y + row});
      constexpr float kPerUnit = 1.0f / Cell::kMeanScale;
      if (cell.hits >= kOften) often_hit_ |= std::uint64_t{1} << bit;
      x_[bit] = static_cast<float>(column) + kPerUnit * cell.mean_x;
      y_[bit] = static_cast<float>(row) + kPerUnit * cell.mean_y;
    }
  }

  // Whether ForEachOccupiedNeighbor can be asked about the cell: the block holds all cells up to
  // two away from it.
  bool Covers(CellIndex index) const {
    return static_cast<unsigned>(index.x - corner_.x - 2) < kSize - 4 &&
           static_cast<unsigned>(index.y - corner_.y - 2) < kSize - 4;
  }

  // How many occupied cells of the 3 x 3 neighborhood of the cell have been hit often: their hit
  // means are good to a fraction of the noise of a range.
  int CountOftenHit(CellIndex index) const {
    const int column = index.x - corner_.x, row = index.y - corner_.y;
    return std::popcount(often_hit_ & kThreeByThree << (kSize * (row - 1) + column - 1));
  }

  // Whether any cell of the 3 x 3 neighborhood of the cell is occupied.
  bool HasOccupiedNeighbor(CellIndex index) const {
    const int column = index.x - corner_.x, row = index.y - corner_.y;
    return (occupied_ & kThreeByThree << (kSize * (row - 1) + column - 1)) != 0;
  }

  // Calls visit(x, y) with the hit mean, in cells relative to the corner of the cell `index`, of
  // every occupied cell of its 3 x 3 neighborhood whose own neighbor in direction (dx, dy), each
  // -1, 0 or 1 and not both 0, is not occupied.
  template <typename Visit>
  void ForEachOccupiedNeighbor(CellIndex index, int dx, int dy, const Visit& visit) const {
    const int toward = kSize * dy + dx;
    const std::uint64_t blocked = toward > 0 ? occupied_ >> toward : occupied_ << -toward;
    VisitNeighbors(occupied_ & ~blocked, index, visit);
  }

  // The same for every occupied cell, whatever is beside it.
  template <typename Visit>
  void ForEachOccupiedNeighbor(CellIndex index, const Visit& visit) const {
    VisitNeighbors(occupied_, index, visit);
  }

  // Calls visit(xs, ys) for each of the three rows of the 3 x 3 neighborhood of the cell `index`:
  // four hit means side by side, in cells relative to the corner of the cell. That of a cell that
  // is not occupied is far away; so is the fourth, which belongs to no neighbor. To be added up
  // without branches, several times as fast as one by one.
  template <typename Visit>
  void ForEachRowOfNeighbors(CellIndex index, const Visit& visit) const {
    const int column = index.x - corner_.x, row = index.y - corner_.y;
    const Eigen::Array4f not_a_neighbor(0.0f, 0.0f, 0.0f, kFarAway);
    for (int r = row - 1; r <= row + 1; ++r) {
      const int first = kSize * r + column - 1;
      const Eigen::Array4f x = Eigen::Map<const Eigen::Array4f>(&x_[first]);
      const Eigen::Array4f y = Eigen::Map<const Eigen::Array4f>(&y_[first]);
      visit(x - static_cast<float>(column) + not_a_neighbor, y - static_cast<float>(row));
    }
  }

 private:
  static constexpr int kSize = 8;
  static constexpr int kCentre = 3;
  static constexpr int kOften = 8;  // hits
  static constexpr std::uint64_t kThreeByThree = 0x070707;
  static constexpr float kFarAway = 1e6f;

  template <typename Visit>
  void VisitNeighbors(std::uint64_t cells, CellIndex index, const Visit& visit) const {
    const int column = index.x - corner_.x, row = index.y - corner_.y;
    std::uint64_t rest = cells & kThreeByThree << (kSize * (row - 1) + column - 1);
    for (; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      visit(x_[bit] - static_cast<float>(column), y_[bit] - static_cast<float>(row));
    }
  }

  CellIndex corner_{-2 * kMaxCellIndex, -2 * kMaxCellIndex};  // covers nothing
  std::uint64_t occupied_ = 0;                                // bit kSize * row + column
  std::uint64_t often_hit_ = 0;
  // Hit means from the corner of the block.
  std::array<float, std::size_t{kSize} * kSize> x_;
  std::array<float, std::size_t{kSize} * kSize> y_;
};

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_CELL_BLOCK_H_
