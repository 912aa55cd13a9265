// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/foxglove_map.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "experiments/view/foxglove_values.h"

namespace gmapping_spa::view {
namespace {

constexpr int kUint8 = 1;  // of foxglove.PackedElementField
constexpr int kSize = map::Tile::kSize;

struct Corners {
  TileIndex min, max;  // of tiles, both included
};

Corners CornersOf(const TileImages& tiles) {
  Corners corners{tiles.begin()->first, tiles.begin()->first};
  for (const auto& [index, image] : tiles) {
    corners.min = {std::min(corners.min.x, index.x), std::min(corners.min.y, index.y)};
    corners.max = {std::max(corners.max.x, index.x), std::max(corners.max.y, index.y)};
  }
  return corners;
}

}  // namespace

std::string Base64(std::string_view bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

nlohmann::json FoxgloveMap(const RunState& run) {
  const double resolution_m = run.title().resolution_m;
  std::string cells;
  int columns = 0;
  backend::SE2 world_T_corner;
  if (!run.tiles().empty()) {
    const auto [min, max] = CornersOf(run.tiles());
    columns = (max.x - min.x + 1) * kSize;
    const int rows = (max.y - min.y + 1) * kSize;
    cells.assign(static_cast<std::size_t>(columns) * rows, static_cast<char>(kUnknownCell));
    for (const auto& [index, image] : run.tiles()) {
      const int column = (index.x - min.x) * kSize, first_row = (index.y - min.y) * kSize;
      for (int row = 0; row < kSize; ++row) {
        const auto to = std::ptrdiff_t{first_row + row} * columns + column;
        std::copy_n(image.begin() + row * kSize, kSize, cells.begin() + to);
      }
    }
    world_T_corner = {min.x * kSize * resolution_m, min.y * kSize * resolution_m, 0.0};
  }
  return {{"timestamp", FoxgloveTime(run.latest().figures.stamp_s)},
          {"frame_id", "map"},
          {"pose", FoxglovePose(world_T_corner)},
          {"column_count", columns},
          {"cell_size", {{"x", resolution_m}, {"y", resolution_m}}},
          {"row_stride", columns},
          {"cell_stride", 1},
          {"fields", {{{"name", "occupancy"}, {"offset", 0}, {"type", kUint8}}}},
          {"data", Base64(cells)}};
}

}  // namespace gmapping_spa::view
