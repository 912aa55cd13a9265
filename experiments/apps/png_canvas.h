// SPDX-License-Identifier: BSD-3-Clause
// A canvas for cairo that ends up in a PNG file.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_PNG_CANVAS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_PNG_CANVAS_H_

#include <cairo.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace gmapping_spa::apps {

class PngCanvas {
 public:
  PngCanvas(int width_px, int height_px)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px)),
        context_(cairo_create(surface_.get())) {}

  cairo_surface_t* surface() const { return surface_.get(); }
  cairo_t* context() const { return context_.get(); }

  // Throws std::runtime_error with one line, also for what went wrong while drawing.
  void Write(const std::string& path) const {
    cairo_status_t status = cairo_status(context_.get());
    if (status == CAIRO_STATUS_SUCCESS) {
      status = cairo_surface_write_to_png(surface_.get(), path.c_str());
    }
    if (status != CAIRO_STATUS_SUCCESS) {
      throw std::runtime_error(
          path + ": expected to write a picture, found: " + cairo_status_to_string(status));
    }
  }

 private:
  struct Deleter {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };

  std::unique_ptr<cairo_surface_t, Deleter> surface_;
  std::unique_ptr<cairo_t, Deleter> context_;
};

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_PNG_CANVAS_H_
