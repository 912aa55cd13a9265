// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/map_picture.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "experiments/apps/picture_view.h"
#include "experiments/apps/png_canvas.h"

namespace gmapping_spa::apps {
namespace {

using backend::Trajectory;
using map::CellState;
using map::TrinaryMap;
using View = PictureView;

constexpr double kMinLongSidePx = 800.0, kMaxLongSidePx = 2000.0;
constexpr double kMarginM = 1.0;
constexpr int kLegendHeightPx = 44;  // a strip below the map, so that the bar hides none of it
constexpr int kUnknownGrey = 205;

// Bounds of the known cells (of the whole map when there are none) and of the trajectory.
View Fit(const TrinaryMap& map, const Trajectory& trajectory) {
  int left = map.width, right = -1, bottom = map.height, top = -1;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) == CellState::kUnknown) continue;
      left = std::min(left, column);
      right = std::max(right, column);
      bottom = std::min(bottom, row);
      top = row;
    }
  }
  if (right < 0) left = bottom = 0, right = map.width - 1, top = map.height - 1;
  View view{map.origin_x_m + left * map.resolution_m, map.origin_y_m + bottom * map.resolution_m,
            map.origin_x_m + (right + 1) * map.resolution_m,
            map.origin_y_m + (top + 1) * map.resolution_m, 0.0};
  for (const auto& [stamp_s, pose] : trajectory) {
    if (!pose.IsFinite()) continue;
    view.min_x_m = std::min(view.min_x_m, pose.x);
    view.min_y_m = std::min(view.min_y_m, pose.y);
    view.max_x_m = std::max(view.max_x_m, pose.x);
    view.max_y_m = std::max(view.max_y_m, pose.y);
  }
  view.min_x_m -= kMarginM;
  view.min_y_m -= kMarginM;
  view.max_x_m += kMarginM;
  view.max_y_m += kMarginM;
  const double long_side_m = std::max(view.max_x_m - view.min_x_m, view.max_y_m - view.min_y_m);
  view.pixels_per_m = std::clamp(1.0 / map.resolution_m, kMinLongSidePx / long_side_m,
                                 kMaxLongSidePx / long_side_m);
  return view;
}

// A range of cells along one axis.
struct Range {
  int begin, end;
};

// The cells of the axis, which has `size` of them, that begin under a pixel, or the one that holds
// it; empty beyond the map. Clamped before the conversion: a diverged trajectory can stretch the
// view to any size.
Range CellsUnderPixel(double first_cell, double cells_per_px, int size) {
  const double begin = std::floor(first_cell);
  const double end = std::max(begin + 1.0, std::floor(first_cell + cells_per_px));
  return {static_cast<int>(std::clamp(begin, 0.0, static_cast<double>(size))),
          static_cast<int>(std::clamp(end, 0.0, static_cast<double>(size)))};
}

std::uint32_t GreyLevel(const TrinaryMap& map, Range columns, Range rows) {
  std::int64_t sum = 0, count = 0;
  for (int row = rows.begin; row < rows.end; ++row) {
    for (int column = columns.begin; column < columns.end; ++column) {
      const CellState state = map.at(column, row);
      // Occupied wins over an average, so that thin walls stay black when the map is reduced.
      if (state == CellState::kOccupied) return 0;
      sum += state == CellState::kFree ? 255 : kUnknownGrey;
      ++count;
    }
  }
  return static_cast<std::uint32_t>(count == 0 ? kUnknownGrey : sum / count);
}

void PaintMap(cairo_surface_t* surface, const TrinaryMap& map, const View& view) {
  cairo_surface_flush(surface);
  unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  const double cells_per_px = 1.0 / (view.pixels_per_m * map.resolution_m);
  for (int y = 0; y < view.height_px(); ++y) {
    auto* line = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    const Range rows =
        CellsUnderPixel((view.max_y_m - map.origin_y_m) / map.resolution_m - (y + 1) * cells_per_px,
                        cells_per_px, map.height);
    for (int x = 0; x < view.width_px(); ++x) {
      const Range columns =
          CellsUnderPixel((view.min_x_m - map.origin_x_m) / map.resolution_m + x * cells_per_px,
                          cells_per_px, map.width);
      line[x] = GreyLevel(map, columns, rows) * 0x010101;
    }
  }
  cairo_surface_mark_dirty(surface);
}

// In the strip below the map: the longest of 1, 2, 5, 10, ... m within a quarter of the width.
void DrawScaleBar(cairo_t* context, const View& view) {
  double length_m = 0.1;
  for (int i = 0;; ++i) {
    const double longer_m = length_m * (i % 3 == 1 ? 2.5 : 2.0);
    if (longer_m * view.pixels_per_m > view.width_px() / 4.0) break;
    length_m = longer_m;
  }
  const double length_px = length_m * view.pixels_per_m;
  const double x = kMarginM * view.pixels_per_m, y = view.height_px() + kLegendHeightPx - 18.0;
  std::ostringstream label;
  label << length_m << " m";

  cairo_rectangle(context, 0.0, view.height_px(), view.width_px(), kLegendHeightPx);
  cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
  cairo_fill(context);
  cairo_set_source_rgb(context, 0.15, 0.15, 0.15);
  cairo_set_line_width(context, 2.0);
  cairo_move_to(context, x, y - 8.0);
  cairo_line_to(context, x, y);
  cairo_line_to(context, x + length_px, y);
  cairo_line_to(context, x + length_px, y - 8.0);
  cairo_stroke(context);
  // Cairo's built-in font: the same picture on every machine, whatever fonts it has.
  cairo_select_font_face(context, "@cairo:", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, 18.0);
  cairo_move_to(context, x + length_px + 10.0, y + 2.0);
  cairo_show_text(context, label.str().c_str());
}

}  // namespace

PicturePlace WriteMapPicture(const TrinaryMap& map, const Trajectory& trajectory,
                             const std::string& png_path, const Stretches& stretches) {
  const View view = Fit(map, trajectory);
  const PngCanvas canvas(view.width_px(), view.height_px() + kLegendHeightPx);
  if (cairo_surface_status(canvas.surface()) == CAIRO_STATUS_SUCCESS) {
    PaintMap(canvas.surface(), map, view);
  }
  DrawTrajectory(canvas.context(), trajectory, stretches, view);
  DrawScaleBar(canvas.context(), view);
  // From the middle of the width on.
  DrawStretchLegend(canvas.context(), stretches, view.width_px() / 2.0,
                    view.height_px() + kLegendHeightPx - 18.0);
  canvas.Write(png_path);
  return {1.0 / view.pixels_per_m, view.min_x_m, view.max_y_m};
}

}  // namespace gmapping_spa::apps
