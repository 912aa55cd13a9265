// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/tile_message.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "experiments/conversion/message_bytes.h"
#include "frontend/map/occupancy_grid.h"

namespace gmapping_spa::view {
namespace {

using conversion::AppendNumber;

constexpr std::size_t kMaxTiles = 4096;  // 1 MB
static_assert(map::kMaxCellIndex / map::Tile::kSize <= 1 << 15, "a tile's index has 16 bits");

}  // namespace

Messages TileMessages(int run, double stamp_s, const TileImages& tiles) {
  Messages messages;
  std::size_t left = tiles.size();
  for (auto tile = tiles.begin(); left > 0;) {
    const std::size_t count = std::min(left, kMaxTiles);
    std::string bytes;
    bytes.reserve(16 + count * (4 + sizeof(TileImage)));
    AppendNumber(std::uint8_t{1}, &bytes);
    AppendNumber(static_cast<std::uint8_t>(run), &bytes);
    AppendNumber(std::uint16_t{0}, &bytes);
    AppendNumber(static_cast<std::uint32_t>(count), &bytes);
    AppendNumber(stamp_s, &bytes);
    for (std::size_t i = 0; i < count; ++i, ++tile) {
      AppendNumber(static_cast<std::int16_t>(tile->first.x), &bytes);
      AppendNumber(static_cast<std::int16_t>(tile->first.y), &bytes);
      bytes.append(tile->second.begin(), tile->second.end());
    }
    messages.push_back(BinaryMessage(std::move(bytes)));
    left -= count;
  }
  return messages;
}

}  // namespace gmapping_spa::view
