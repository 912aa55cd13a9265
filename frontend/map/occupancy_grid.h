// SPDX-License-Identifier: BSD-3-Clause
// The map of one particle: an unbounded grid of cells whose copies share what they have in common.
#ifndef GMAPPING_SPA_FRONTEND_MAP_OCCUPANCY_GRID_H_
#define GMAPPING_SPA_FRONTEND_MAP_OCCUPANCY_GRID_H_

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "frontend/map/tile.h"

namespace gmapping_spa::map {

// Index of a cell: it covers [x, x + 1) * resolution_m in the world's x, likewise in y.
struct CellIndex {
  int x = 0;
  int y = 0;
  friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

// Largest distance from the origin that a grid covers, in cells. At 0.05 m this is 26 km.
inline constexpr int kMaxCellIndex = 1 << 19;

// Index along one axis of the cell that holds a coordinate given in cells. A conversion after a
// shift into the positive, because std::floor is a function call on baseline x86-64.
// Precondition: |coordinate| < kMaxCellIndex.
inline int FloorToCell(double coordinate) {
  return static_cast<int>(coordinate + kMaxCellIndex) - kMaxCellIndex;
}

// Copying costs a pointer a tile; a tile is duplicated when one of its owners first writes to it.
// Different grids may be used by different threads at once even while they share tiles.
class OccupancyGrid {
 public:
  struct Options {
    double resolution_m = 0.05;
    // A cell is an obstacle for scan matching when more than this part of the beams that met it
    // ended there (GMapping's "fullness").
    double occupied_threshold = 0.1;
    friend bool operator==(const Options&, const Options&) = default;
  };

  explicit OccupancyGrid(const Options& options);

  double resolution_m() const { return options_.resolution_m; }

  // Counts a beam that passed through the cells of the Bresenham line from `from` up to but without
  // `to`.
  void AddPasses(CellIndex from, CellIndex to);

  // Counts a beam that ended at (x, y), given in cells.
  void AddHit(double x_cells, double y_cells);

  // The cell, all zero where no beam has been.
  const Cell& cell(CellIndex index) const {
    const Tile* tile = FindTile(index.x >> Tile::kShift, index.y >> Tile::kShift);
    return tile ? tile->cell(index.x & Tile::kMask, index.y & Tile::kMask) : kEmptyCell;
  }

  // Whether the eight cells (x, y) ... (x + 7, y) are occupied, from the lowest bit up.
  std::uint32_t OccupiedBits(CellIndex index) const {
    const int tile_x = index.x >> Tile::kShift, tile_y = index.y >> Tile::kShift;
    const int shift = index.x & Tile::kMask, row = index.y & Tile::kMask;
    std::uint32_t bits = 0;
    if (const Tile* tile = FindTile(tile_x, tile_y)) bits = tile->occupied[row] >> shift;
    if (shift > Tile::kSize - 8) {
      const Tile* next = FindTile(tile_x + 1, tile_y);
      if (next) bits |= static_cast<std::uint32_t>(next->occupied[row]) << (Tile::kSize - shift);
    }
    return bits & 0xff;
  }

  // The tile that holds the cells (x, y) with x / kSize = tile_x, likewise in y, rounded down; null
  // where no beam has been. As long as a copy of the grid lives, the same address means that
  // nothing has changed there since it was made.
  const Tile* FindTile(int tile_x, int tile_y) const {
    const unsigned column = static_cast<unsigned>(tile_x - first_tile_x_);
    const unsigned row = static_cast<unsigned>(tile_y - first_tile_y_);
    if (column >= tile_columns_ || row >= tile_rows_) return nullptr;
    return tiles_[static_cast<std::size_t>(row) * tile_columns_ + column].get();
  }

  // Smallest rectangle of whole tiles that holds every known cell: [min, max) in cells. Empty
  // (min == max) when nothing is known.
  struct Extent {
    CellIndex min;
    CellIndex max;
  };
  Extent KnownExtent() const;

  // Number of tiles held, and of those that no other grid shares.
  std::size_t CountTiles() const;
  std::size_t CountOwnTiles() const;

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(first_tile_x_, first_tile_y_, tile_columns_, tile_rows_, tiles_);
    if (!HasAllTiles()) throw std::runtime_error("a grid without all of its tiles");
  }

 private:
  static const Cell kEmptyCell;

  // Whether there are as many as the rectangle says, and it is one that scans can make.
  bool HasAllTiles() const;
  // A tile that only this grid owns, made or duplicated if need be.
  Tile& WritableTile(int tile_x, int tile_y);
  void GrowToHold(int tile_x, int tile_y);
  void UpdateOccupied(Tile& tile, int x, int y) const;

  Options options_;
  // Directory of tiles: a rectangle of tile indices, grown in whichever direction is needed.
  int first_tile_x_ = 0;
  int first_tile_y_ = 0;
  unsigned tile_columns_ = 0;
  unsigned tile_rows_ = 0;
  std::vector<TilePtr> tiles_;
};

}  // namespace gmapping_spa::map

#endif  // GMAPPING_SPA_FRONTEND_MAP_OCCUPANCY_GRID_H_
