// SPDX-License-Identifier: BSD-3-Clause
// Which tiles of a map look otherwise than when it was shown last.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_DIFFER_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_DIFFER_H_

#include <optional>

#include "experiments/view/tile_image.h"
#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::view {

// Tiles that two grids share are not looked at. Of the others the pictures decide: after a
// correction every tile of a map is a new one, and most look as before.
class TileDiffer {
 public:
  // Takes over the map; returns the tiles that look otherwise than in the one before. A tile that
  // is gone has an unknown image.
  TileImages Update(const map::OccupancyGrid& grid);
  TileImages Update(const map::TrinaryMap& map);

  // Of the map taken over last; those all unknown are left out.
  const TileImages& images() const { return images_; }

  // Holds no tiles of grids any more, so that their owner need not duplicate them. Changes nothing
  // of what Update returns.
  void ReleaseGrid() { before_.reset(); }

 private:
  void Compare(TileIndex index, const TileImage& image, TileImages* changed);

  std::optional<map::OccupancyGrid> before_;
  TileImages images_;
};

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_DIFFER_H_
