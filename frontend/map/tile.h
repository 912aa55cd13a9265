// SPDX-License-Identifier: BSD-3-Clause
// The storage unit of an occupancy grid: a square block of cells, shared between grids until
// written.
#ifndef GMAPPING_SPA_FRONTEND_MAP_TILE_H_
#define GMAPPING_SPA_FRONTEND_MAP_TILE_H_

#include <array>
#include <boost/intrusive_ptr.hpp>
#include <boost/smart_ptr/intrusive_ref_counter.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace gmapping_spa::map {

// How often beams ended in a cell and how often they met it, and where in the cell they ended on
// average (the sub-cell hit mean of GMapping's point accumulator).
struct Cell {
  static constexpr int kMeanScale = 1 << 16;

  std::uint16_t hits = 0;
  std::uint16_t visits = 0;  // hits and passes
  std::uint16_t mean_x = 0;  // of the hits, from the lower left corner, in cells / kMeanScale
  std::uint16_t mean_y = 0;

  void AddPass() {
    if (visits == std::numeric_limits<std::uint16_t>::max()) Halve();
    ++visits;
  }

  // (x, y): where the beam ended, in units of mean_x.
  void AddHit(std::uint16_t x, std::uint16_t y) {
    AddPass();
    ++hits;
    mean_x = MovedMean(mean_x, x, hits);
    mean_y = MovedMean(mean_y, y, hits);
  }

 private:
  // Counters that are about to overflow forget half of the past and keep their ratio.
  void Halve() {
    hits /= 2;
    visits /= 2;
  }

  static std::uint16_t MovedMean(int mean, int sample, int count) {
    const int difference = sample - mean;
    const int rounding = difference < 0 ? -count / 2 : count / 2;
    return static_cast<std::uint16_t>(mean + (difference + rounding) / count);
  }
};
static_assert(sizeof(Cell) == 8, "a particle's memory is mostly cells");

// 16 x 16 cells. The reference count makes copy on write cheap; its acquire load in use_count() is
// what makes "I am the only owner" safe to act upon while other threads drop their references.
struct Tile : boost::intrusive_ref_counter<Tile, boost::thread_safe_counter> {
  static constexpr int kShift = 4;
  static constexpr int kSize = 1 << kShift;
  static constexpr int kMask = kSize - 1;

  std::array<Cell, std::size_t{kSize} * kSize> cells{};
  // Bit x of occupied[y]: the cell counts as an obstacle for scan matching. Redundant with the
  // cells, kept because a matcher asks nine cells per beam and nearly all of them are empty.
  std::array<std::uint16_t, kSize> occupied{};

  Cell& cell(int x, int y) { return cells[y * kSize + x]; }
  const Cell& cell(int x, int y) const { return cells[y * kSize + x]; }
};

using TilePtr = boost::intrusive_ptr<Tile>;

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_TILE_H_
