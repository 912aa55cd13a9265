// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/error_picture.h"

#include <cairo.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "experiments/apps/png_canvas.h"

namespace gmapping_spa::apps {
namespace {

using metrics::MapComparison;

constexpr double kMinWidth_px = 800.0;
constexpr int kLegendHeight_px = 40;

struct Color {
  double red, green, blue;
};
constexpr Color kWhite{1.0, 1.0, 1.0}, kUnseen{0.85, 0.85, 0.85}, kRight{0.55, 0.55, 0.55},
    kFound{0.0, 0.0, 0.0}, kMissing{0.0, 0.45, 0.70}, kOff{0.84, 0.37, 0.0};

void SetColor(cairo_t* cairo, const Color& color) {
  cairo_set_source_rgb(cairo, color.red, color.green, color.blue);
}

void FillSquare(cairo_t* cairo, double center_x, double center_y, double side) {
  cairo_rectangle(cairo, center_x - 0.5 * side, center_y - 0.5 * side, side, side);
  cairo_fill(cairo);
}

void DrawSeenSpace(cairo_t* cairo, const map::TrinaryMap& truth, const metrics::SeenSpace& seen) {
  SetColor(cairo, kUnseen);
  cairo_paint(cairo);
  SetColor(cairo, kWhite);
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);  // no seams between cells
  for (int row = 0; row < seen.height; ++row) {
    for (int column = 0; column < seen.width; ++column) {
      if (!seen.IsSeen(column, row)) continue;
      FillSquare(cairo, truth.origin_x_m + (column + 0.5) * truth.resolution_m,
                 truth.origin_y_m + (row + 0.5) * truth.resolution_m, truth.resolution_m);
    }
  }
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
}

void DrawCells(cairo_t* cairo, const MapComparison& comparison, double tolerance_m, bool right) {
  SetColor(cairo, right ? kRight : kOff);
  for (const metrics::ComparedCell& cell : comparison.cells) {
    if (metrics::IsWithin(cell.distance_m, tolerance_m) != right) continue;
    FillSquare(cairo, cell.center.x(), cell.center.y(), comparison.map_resolution_m);
  }
}

void DrawSurface(cairo_t* cairo, const MapComparison& comparison, double tolerance_m, bool found) {
  SetColor(cairo, found ? kFound : kMissing);
  cairo_set_line_width(cairo, (found ? 0.6 : 2.0) * comparison.truth_resolution_m);
  for (std::size_t i = 0; i < comparison.surface.size(); ++i) {
    if (metrics::IsWithin(comparison.elements[i].distance_m, tolerance_m) != found) continue;
    const metrics::Segment& edge = comparison.surface[i].edge;
    cairo_move_to(cairo, edge.from.x(), edge.from.y());
    cairo_line_to(cairo, edge.to.x(), edge.to.y());
  }
  cairo_stroke(cairo);
}

void DrawLegend(cairo_t* cairo, double width_px, double top_px) {
  cairo_rectangle(cairo, 0.0, top_px, width_px, kLegendHeight_px);
  SetColor(cairo, kWhite);
  cairo_fill(cairo);
  // Cairo's built-in font: the same picture on every machine, whatever fonts it has.
  cairo_select_font_face(cairo, "@cairo:", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, 16.0);
  double x_px = 20.0;
  for (const auto& [color, text] :
       {std::pair(kFound, "true boundary, found"), std::pair(kMissing, "missing"),
        std::pair(kRight, "map, right"), std::pair(kOff, "map, wrong"),
        std::pair(kUnseen, "never in sight")}) {
    SetColor(cairo, color);
    FillSquare(cairo, x_px, top_px + 0.5 * kLegendHeight_px, 14.0);
    SetColor(cairo, kFound);
    cairo_move_to(cairo, x_px + 14.0, top_px + 0.5 * kLegendHeight_px + 5.0);
    cairo_show_text(cairo, text);
    double unused_y = 0.0;
    cairo_get_current_point(cairo, &x_px, &unused_y);
    x_px += 30.0;
  }
}

}  // namespace

void WriteErrorPicture(const map::TrinaryMap& truth, const MapComparison& comparison,
                       double tolerance_m, const std::string& png_path) {
  const double pixels_per_cell = std::max(2.0, kMinWidth_px / truth.width);
  const double pixels_per_m = pixels_per_cell / truth.resolution_m;
  const int width_px = static_cast<int>(truth.width * pixels_per_cell);
  const int height_px = static_cast<int>(truth.height * pixels_per_cell);
  const PngCanvas canvas(width_px, height_px + kLegendHeight_px);
  cairo_t* const cairo = canvas.context();
  cairo_save(cairo);
  cairo_translate(cairo, 0.0, height_px);
  cairo_scale(cairo, pixels_per_m, -pixels_per_m);
  cairo_translate(cairo, -truth.origin_x_m, -truth.origin_y_m);
  DrawSeenSpace(cairo, truth, comparison.seen);
  // What is wrong lies on top.
  DrawCells(cairo, comparison, tolerance_m, /*right=*/true);
  DrawSurface(cairo, comparison, tolerance_m, /*found=*/true);
  DrawSurface(cairo, comparison, tolerance_m, /*found=*/false);
  DrawCells(cairo, comparison, tolerance_m, /*right=*/false);
  cairo_restore(cairo);
  DrawLegend(cairo, width_px, height_px);
  canvas.Write(png_path);
}

}  // namespace gmapping_spa::apps
