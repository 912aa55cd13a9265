// SPDX-License-Identifier: BSD-3-Clause
// Tiles on their way to the page.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_MESSAGE_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_MESSAGE_H_

#include "experiments/view/message.h"
#include "experiments/view/tile_image.h"

namespace gmapping_spa::view {

// As many messages as it takes, 4096 tiles each at most; none for no tiles. Little endian:
//   uint8 1, uint8 run, uint16 0, uint32 number of tiles, float64 stamp of the log in s,
//   then a tile each: int16 x, int16 y, 256 bytes of its image.
Messages TileMessages(int run, double stamp_s, const TileImages& tiles);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_TILE_MESSAGE_H_
