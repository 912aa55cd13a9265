// SPDX-License-Identifier: BSD-3-Clause
// Tiles of maps as pictures.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_IMAGE_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_IMAGE_H_

#include <array>
#include <compare>
#include <cstdint>
#include <map>

#include "frontend/map/tile.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::view {

// Covers the cells [16 x, 16 x + 16), likewise in y.
struct TileIndex {
  int x = 0;
  int y = 0;
  friend auto operator<=>(const TileIndex&, const TileIndex&) = default;
};

// A byte a cell, as in ROS's OccupancyGrid: 0 free to 100 occupied, the part of the beams that
// ended there in percent; kUnknownCell where none has been. Rows from the smallest y up.
inline constexpr std::uint8_t kUnknownCell = 255;
using TileImage = std::array<std::uint8_t, std::size_t{map::Tile::kSize} * map::Tile::kSize>;
using TileImages = std::map<TileIndex, TileImage>;

TileImage UnknownImage();
TileImage ImageOf(const map::Tile& tile);

// Of a finished map: free 0, occupied 100. Its origin is rounded to a whole cell, which it is in
// the maps of gmapping_spa.
TileImages ImagesOf(const map::TrinaryMap& map);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_IMAGE_H_
