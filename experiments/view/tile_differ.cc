// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/tile_differ.h"

#include <algorithm>
#include <vector>

namespace gmapping_spa::view {
namespace {

using map::OccupancyGrid;
using map::Tile;

}  // namespace

void TileDiffer::Compare(TileIndex index, const TileImage& image, TileImages* changed) {
  static const TileImage kUnknown = UnknownImage();
  const auto known = images_.find(index);
  if (image == (known == images_.end() ? kUnknown : known->second)) return;
  changed->insert({index, image});
  if (image == kUnknown) {
    images_.erase(known);
  } else {
    images_.insert_or_assign(index, image);
  }
}

TileImages TileDiffer::Update(const OccupancyGrid& grid) {
  TileImages changed;
  // What was there and is not any more.
  std::vector<TileIndex> gone;
  for (const auto& [index, image] : images_) {
    if (grid.FindTile(index.x, index.y) == nullptr) gone.push_back(index);
  }
  for (const TileIndex& index : gone) Compare(index, UnknownImage(), &changed);
  const OccupancyGrid::Extent extent = grid.KnownExtent();
  for (int y = extent.min.y >> Tile::kShift; y < extent.max.y >> Tile::kShift; ++y) {
    for (int x = extent.min.x >> Tile::kShift; x < extent.max.x >> Tile::kShift; ++x) {
      const Tile* tile = grid.FindTile(x, y);
      if (tile == nullptr || (before_ && before_->FindTile(x, y) == tile)) continue;
      Compare({x, y}, ImageOf(*tile), &changed);
    }
  }
  before_ = grid;
  return changed;
}

TileImages TileDiffer::Update(const map::TrinaryMap& map) {
  TileImages changed;
  TileImages images = ImagesOf(map);
  for (const auto& [index, image] : images_) images.try_emplace(index, UnknownImage());
  for (const auto& [index, image] : images) Compare(index, image, &changed);
  before_.reset();
  return changed;
}

}  // namespace gmapping_spa::view
