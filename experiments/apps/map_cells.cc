// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/map_cells.h"

#include <png.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "frontend/map/map_server_io.h"

namespace gmapping_spa::apps {

PicturePlace WriteMapCells(const map::TrinaryMap& map, const std::string& png_path) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(map.cells.size());
  std::ranges::transform(map.cells, std::back_inserter(pixels), map::PixelOf);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(map.width);
  image.height = static_cast<png_uint_32>(map.height);
  image.format = PNG_FORMAT_GRAY;
  // Row 0 of a map is at the bottom, that of a picture at the top: a negative stride.
  if (png_image_write_to_file(&image, png_path.c_str(), /*convert_to_8_bit=*/0, pixels.data(),
                              -map.width, /*colormap=*/nullptr) == 0) {
    throw std::runtime_error(png_path + ": expected to write a picture, found: " + image.message);
  }
  return {map.resolution_m, map.origin_x_m, map.origin_y_m + map.height * map.resolution_m};
}

}  // namespace gmapping_spa::apps
