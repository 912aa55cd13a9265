// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/occupancy_grid.h"

#include <glog/logging.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace gmapping_spa::map {
namespace {

constexpr int kMaxTile = kMaxCellIndex >> Tile::kShift;
// So that a robot that drives on does not copy the directory with every scan.
constexpr int kMargin = 4;

}  // namespace

const Cell OccupancyGrid::kEmptyCell;

OccupancyGrid::OccupancyGrid(const Options& options) : options_(options) {
  CHECK_GT(options.resolution_m, 0.0);
}

void OccupancyGrid::AddPasses(CellIndex from, CellIndex to) {
  const int dx = std::abs(to.x - from.x), dy = std::abs(to.y - from.y);
  const int step_x = from.x < to.x ? 1 : -1, step_y = from.y < to.y ? 1 : -1;
  int error = dx - dy;
  Tile* tile = nullptr;  // that holds `at`; a line stays in one for many cells
  CellIndex tile_index;
  for (CellIndex at = from; at != to;) {
    const CellIndex needed{at.x >> Tile::kShift, at.y >> Tile::kShift};
    if (!tile || needed != tile_index) {
      tile = &WritableTile(needed.x, needed.y);
      tile_index = needed;
    }
    const int x = at.x & Tile::kMask, y = at.y & Tile::kMask;
    Cell& cell = tile->cell(x, y);
    cell.AddPass();
    if (cell.hits > 0) UpdateOccupied(*tile, x, y);

    // All ones or all zeros instead of branches, which nobody could predict.
    const int twice = 2 * error;
    const int moves_x = -static_cast<int>(twice > -dy), moves_y = -static_cast<int>(twice < dx);
    error += (dx & moves_y) - (dy & moves_x);
    at.x += step_x & moves_x;
    at.y += step_y & moves_y;
  }
}

void OccupancyGrid::AddHit(double x_cells, double y_cells) {
  const CellIndex index{FloorToCell(x_cells), FloorToCell(y_cells)};
  Tile& tile = WritableTile(index.x >> Tile::kShift, index.y >> Tile::kShift);
  const int x = index.x & Tile::kMask, y = index.y & Tile::kMask;
  tile.cell(x, y).AddHit(static_cast<std::uint16_t>((x_cells - index.x) * Cell::kMeanScale),
                         static_cast<std::uint16_t>((y_cells - index.y) * Cell::kMeanScale));
  UpdateOccupied(tile, x, y);
}

void OccupancyGrid::UpdateOccupied(Tile& tile, int x, int y) const {
  const Cell& cell = tile.cell(x, y);
  const auto bit = static_cast<std::uint16_t>(1u << x);
  if (cell.hits > options_.occupied_threshold * cell.visits) {
    tile.occupied[y] |= bit;
  } else {
    tile.occupied[y] &= static_cast<std::uint16_t>(~bit);
  }
}

Tile& OccupancyGrid::WritableTile(int tile_x, int tile_y) {
  GrowToHold(tile_x, tile_y);
  TilePtr& tile = tiles_[static_cast<std::size_t>(tile_y - first_tile_y_) * tile_columns_ +
                         (tile_x - first_tile_x_)];
  if (!tile) {
    tile = new Tile;
  } else if (tile->use_count() > 1) {
    tile = new Tile(*tile);
  }
  return *tile;
}

void OccupancyGrid::GrowToHold(int tile_x, int tile_y) {
  const bool inside = static_cast<unsigned>(tile_x - first_tile_x_) < tile_columns_ &&
                      static_cast<unsigned>(tile_y - first_tile_y_) < tile_rows_;
  if (inside) return;
  CHECK(std::abs(tile_x) <= kMaxTile && std::abs(tile_y) <= kMaxTile);
  int min_x = tile_x - kMargin, max_x = tile_x + kMargin + 1;
  int min_y = tile_y - kMargin, max_y = tile_y + kMargin + 1;
  if (!tiles_.empty()) {
    min_x = tile_x < first_tile_x_ ? min_x : first_tile_x_;
    min_y = tile_y < first_tile_y_ ? min_y : first_tile_y_;
    const int end_x = first_tile_x_ + static_cast<int>(tile_columns_);
    const int end_y = first_tile_y_ + static_cast<int>(tile_rows_);
    max_x = tile_x >= end_x ? max_x : end_x;
    max_y = tile_y >= end_y ? max_y : end_y;
  }
  const unsigned columns = max_x - min_x, rows = max_y - min_y;
  std::vector<TilePtr> grown(static_cast<std::size_t>(columns) * rows);
  for (unsigned row = 0; row < tile_rows_; ++row) {
    const auto from = tiles_.begin() + static_cast<std::ptrdiff_t>(row) * tile_columns_;
    const auto to = grown.begin() +
                    static_cast<std::ptrdiff_t>(row + first_tile_y_ - min_y) * columns +
                    (first_tile_x_ - min_x);
    std::move(from, from + tile_columns_, to);
  }
  tiles_ = std::move(grown);
  first_tile_x_ = min_x;
  first_tile_y_ = min_y;
  tile_columns_ = columns;
  tile_rows_ = rows;
}

bool OccupancyGrid::HasAllTiles() const {
  const auto is_within = [](int first, unsigned count) {
    constexpr int kMost = kMaxTile + kMargin + 1;
    return first >= -kMost && first <= kMost && count <= static_cast<unsigned>(kMost - first);
  };
  return is_within(first_tile_x_, tile_columns_) && is_within(first_tile_y_, tile_rows_) &&
         (tile_columns_ > 0) == (tile_rows_ > 0) &&
         tiles_.size() == std::size_t{tile_columns_} * tile_rows_;
}

OccupancyGrid::Extent OccupancyGrid::KnownExtent() const {
  Extent extent{{kMaxCellIndex, kMaxCellIndex}, {-kMaxCellIndex, -kMaxCellIndex}};
  bool known = false;
  for (unsigned row = 0; row < tile_rows_; ++row) {
    for (unsigned column = 0; column < tile_columns_; ++column) {
      if (!tiles_[static_cast<std::size_t>(row) * tile_columns_ + column]) continue;
      const int x = (first_tile_x_ + static_cast<int>(column)) * Tile::kSize;
      const int y = (first_tile_y_ + static_cast<int>(row)) * Tile::kSize;
      known = true;
      extent.min = {std::min(extent.min.x, x), std::min(extent.min.y, y)};
      extent.max = {std::max(extent.max.x, x + Tile::kSize),
                    std::max(extent.max.y, y + Tile::kSize)};
    }
  }
  return known ? extent : Extent{};
}

std::size_t OccupancyGrid::CountTiles() const {
  return static_cast<std::size_t>(
      std::count_if(tiles_.begin(), tiles_.end(), [](const TilePtr& t) { return t != nullptr; }));
}

std::size_t OccupancyGrid::CountOwnTiles() const {
  return static_cast<std::size_t>(std::count_if(
      tiles_.begin(), tiles_.end(), [](const TilePtr& t) { return t && t->use_count() == 1; }));
}

}  // namespace gmapping_spa::map
