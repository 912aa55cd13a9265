// A small part of an occupancy grid, copied out for a search that stays near one place.
#ifndef GMAPPING_SPA_FRONTEND_MAP_CELL_BLOCK_H_
#define GMAPPING_SPA_FRONTEND_MAP_CELL_BLOCK_H_

#include <array>
#include <bit>
#include <cstdint>

#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::map {

// 8 x 8 cells: which of them are full, as the bits of one word, and the hit means of those. Asking
// the grid itself costs several times as much, and a scan matcher asks for the same cells again and
// again.
class CellBlock {
 public:
  // Copies the block around `centre`.
  void CopyFrom(const OccupancyGrid& grid, CellIndex centre) {
    corner_ = {centre.x - kCentre, centre.y - kCentre};
    full_ = 0;
    for (int row = 0; row < kSize; ++row) {
      const std::uint64_t bits = grid.FullBits({corner_.x, corner_.y + row});
      full_ |= bits << (kSize * row);
    }
    for (std::uint64_t rest = full_; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      const Cell& cell = grid.cell({corner_.x + bit % kSize, corner_.y + bit / kSize});
      means_[bit] = {cell.mean_x, cell.mean_y};
    }
  }

  // Whether ForEachFullNeighbour can be asked about the cell: the block holds all cells up to two
  // away from it.
  bool Covers(CellIndex index) const {
    return static_cast<unsigned>(index.x - corner_.x - 2) < kSize - 4 &&
           static_cast<unsigned>(index.y - corner_.y - 2) < kSize - 4;
  }

  // Calls visit(x, y) with the hit mean, in cells relative to the corner of the cell `index`, of
  // every full cell of its 3 x 3 neighbourhood whose own neighbour in direction (dx, dy), each -1,
  // 0 or 1, is not full; of every full cell when both are 0.
  template <typename Visit>
  void ForEachFullNeighbour(CellIndex index, int dx, int dy, const Visit& visit) const {
    const int column = index.x - corner_.x, row = index.y - corner_.y;
    constexpr std::uint64_t kThreeByThree = 0x070707;
    const int toward = kSize * dy + dx;
    const std::uint64_t blocked = toward == 0 ? 0 : toward > 0 ? full_ >> toward : full_ << -toward;
    std::uint64_t rest = full_ & ~blocked & kThreeByThree << (kSize * (row - 1) + column - 1);
    for (; rest != 0; rest &= rest - 1) {
      const int bit = std::countr_zero(rest);
      const Mean& mean = means_[bit];
      constexpr float kPerUnit = 1.0f / Cell::kMeanScale;
      visit(static_cast<float>(bit % kSize - column) + kPerUnit * mean.x,
            static_cast<float>(bit / kSize - row) + kPerUnit * mean.y);
    }
  }

 private:
  static constexpr int kSize = 8;
  static constexpr int kCentre = 3;
  struct Mean {
    std::uint16_t x, y;
  };

  CellIndex corner_{-2 * kMaxCellIndex, -2 * kMaxCellIndex};  // covers nothing
  std::uint64_t full_ = 0;                                    // bit kSize * row + column
  std::array<Mean, kSize * kSize> means_;                     // of the full cells only
};

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_CELL_BLOCK_H_
