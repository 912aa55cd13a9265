// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/tile_image.h"

#include <cmath>
#include <cstddef>

namespace gmapping_spa::view {

using map::Tile;

TileImage UnknownImage() {
  TileImage image;
  image.fill(kUnknownCell);
  return image;
}

TileImage ImageOf(const Tile& tile) {
  TileImage image;
  for (std::size_t i = 0; i < image.size(); ++i) {
    const map::Cell& cell = tile.cells[i];
    image[i] = cell.visits == 0 ? kUnknownCell
                                : static_cast<std::uint8_t>(100 * int{cell.hits} / cell.visits);
  }
  return image;
}

TileImages ImagesOf(const map::TrinaryMap& map) {
  const int first_x = static_cast<int>(std::lround(map.origin_x_m / map.resolution_m));
  const int first_y = static_cast<int>(std::lround(map.origin_y_m / map.resolution_m));
  TileImages images;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const map::CellState state = map.at(column, row);
      if (state == map::CellState::kUnknown) continue;
      const int x = first_x + column, y = first_y + row;
      const TileIndex index{x >> Tile::kShift, y >> Tile::kShift};
      TileImage& image = images.try_emplace(index, UnknownImage()).first->second;
      image[(y & Tile::kMask) * Tile::kSize + (x & Tile::kMask)] =
          state == map::CellState::kOccupied ? 100 : 0;
    }
  }
  return images;
}

}  // namespace gmapping_spa::view
