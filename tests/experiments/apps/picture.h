// SPDX-License-Identifier: BSD-3-Clause
// Pictures that programs draw, as pixels.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_PICTURE_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_PICTURE_H_

#include <cairo.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gmapping_spa::apps {

struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;  // 0xRRGGBB, by rows from the top

  std::uint32_t at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

// Reads a PNG file.
inline Picture ReadPicture(const std::string& path) {
  cairo_surface_t* surface = cairo_image_surface_create_from_png(path.c_str());
  Picture picture{
      cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  for (int y = 0; y < picture.height; ++y) {
    const auto* line = reinterpret_cast<const std::uint32_t*>(
        cairo_image_surface_get_data(surface) + y * cairo_image_surface_get_stride(surface));
    for (int x = 0; x < picture.width; ++x) picture.pixels.push_back(line[x] & 0xffffff);
  }
  cairo_surface_destroy(surface);
  return picture;
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_APPS_PICTURE_H_
