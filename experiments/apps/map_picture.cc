#include "experiments/apps/map_picture.h"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <sstream>

#include "experiments/apps/png_canvas.h"

namespace gmapping_spa::apps {
namespace {

using backend::StampedPose;
using backend::Trajectory;
using map::CellState;
using map::TrinaryMap;

constexpr double kMinLongSidePx = 800.0, kMaxLongSidePx = 2000.0;
constexpr double kMarginM = 1.0;
constexpr int kLegendHeightPx = 44;  // a strip below the map, so that the bar hides none of it
constexpr int kUnknownGrey = 205;

struct Color {
  double red, green, blue;
};

// The part of the world that is shown and how it is mapped to pixels.
struct View {
  double min_x_m, min_y_m, max_x_m, max_y_m;
  double pixels_per_m;

  double Column(double x_m) const { return (x_m - min_x_m) * pixels_per_m; }
  double Row(double y_m) const { return (max_y_m - y_m) * pixels_per_m; }
  int width_px() const { return std::max(1, static_cast<int>(std::lround(Column(max_x_m)))); }
  int height_px() const { return std::max(1, static_cast<int>(std::lround(Row(min_y_m)))); }
};

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
  long sum = 0, count = 0;
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

// Blue, cyan-green, orange, red: distinguishable along the way and on white.
Color ColorOfProgress(double progress) {
  constexpr std::array<Color, 4> kStops = {
      {{0.10, 0.25, 0.85}, {0.00, 0.62, 0.62}, {0.93, 0.60, 0.05}, {0.85, 0.10, 0.10}}};
  const double position = progress * (kStops.size() - 1);
  const auto index = std::min(static_cast<std::size_t>(position), kStops.size() - 2);
  const double share = position - static_cast<double>(index);
  const Color &from = kStops[index], &to = kStops[index + 1];
  return {std::lerp(from.red, to.red, share), std::lerp(from.green, to.green, share),
          std::lerp(from.blue, to.blue, share)};
}

void DrawDisc(cairo_t* context, const View& view, const backend::SE2& pose, const Color& color) {
  cairo_arc(context, view.Column(pose.x), view.Row(pose.y), 7.0, 0.0, 2.0 * std::numbers::pi);
  cairo_set_source_rgb(context, color.red, color.green, color.blue);
  cairo_fill_preserve(context);
  cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
  cairo_set_line_width(context, 1.5);
  cairo_stroke(context);
}

// A kind of stretch and its lines: a broad one, and on it a dashed one (of no width: none).
struct StretchStyle {
  const char* kind;
  Color color;
  double width_px;
  Color dash_color;
  double dash_width_px;
};
constexpr StretchStyle kStretchStyles[] = {
    {"ambiguous", {0.90, 0.00, 0.90}, 5.0, {}, 0.0},
    {"lost", {1.00, 1.00, 1.00}, 7.0, {0.00, 0.00, 0.00}, 3.0},
};

// Strokes the current path and forgets it.
void Stroke(cairo_t* context, const StretchStyle& style) {
  cairo_set_source_rgb(context, style.color.red, style.color.green, style.color.blue);
  cairo_set_line_width(context, style.width_px);
  cairo_stroke_preserve(context);
  if (style.dash_width_px > 0.0) {
    constexpr double kDash_px[] = {6.0, 4.0};
    cairo_set_source_rgb(context, style.dash_color.red, style.dash_color.green,
                         style.dash_color.blue);
    cairo_set_line_width(context, style.dash_width_px);
    cairo_set_dash(context, kDash_px, std::size(kDash_px), 0.0);
    cairo_stroke_preserve(context);
    cairo_set_dash(context, nullptr, 0, 0.0);
  }
  cairo_new_path(context);
}

bool Has(const Stretches& stretches, const char* kind) {
  const auto found = stretches.find(kind);
  return found != stretches.end() && !found->second.empty();
}

void DrawStretches(cairo_t* context, const Trajectory& finite, const Stretches& stretches,
                   const View& view) {
  const auto before = [](const StampedPose& pose, double stamp_s) {
    return pose.stamp_s < stamp_s;
  };
  const auto after = [](double stamp_s, const StampedPose& pose) { return stamp_s < pose.stamp_s; };
  for (const StretchStyle& style : kStretchStyles) {
    if (!Has(stretches, style.kind)) continue;
    for (const frontend::Stretch& stretch : stretches.at(style.kind)) {
      auto begin = std::lower_bound(finite.begin(), finite.end(), stretch.begin_s, before);
      auto end = std::upper_bound(begin, finite.end(), stretch.end_s, after);
      // The lines to its neighbors are part of it, so that a single scan shows.
      if (begin != finite.begin()) --begin;
      if (end != finite.end()) ++end;
      for (; begin != end; ++begin) {
        const backend::SE2& pose = begin->world_T_robot;
        cairo_line_to(context, view.Column(pose.x), view.Row(pose.y));
      }
      Stroke(context, style);
    }
  }
}

void DrawTrajectory(cairo_t* context, const Trajectory& trajectory, const Stretches& stretches,
                    const View& view) {
  // Strokes of many poses, not of one: colours change slowly, and joints of strokes would show.
  constexpr std::size_t kStrokes = 256;
  Trajectory finite;
  std::copy_if(trajectory.begin(), trajectory.end(), std::back_inserter(finite),
               [](const StampedPose& pose) { return pose.world_T_robot.IsFinite(); });
  if (finite.empty()) return;
  const std::size_t poses_per_stroke = finite.size() / kStrokes + 1;
  cairo_set_line_width(context, 2.0);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  for (std::size_t begin = 0; begin + 1 < finite.size(); begin += poses_per_stroke) {
    const std::size_t end = std::min(begin + poses_per_stroke, finite.size() - 1);
    for (std::size_t i = begin; i <= end; ++i) {
      const backend::SE2& pose = finite[i].world_T_robot;
      cairo_line_to(context, view.Column(pose.x), view.Row(pose.y));
    }
    const Color color =
        ColorOfProgress(static_cast<double>(begin) / static_cast<double>(finite.size()));
    cairo_set_source_rgb(context, color.red, color.green, color.blue);
    cairo_stroke(context);
  }
  DrawStretches(context, finite, stretches, view);
  DrawDisc(context, view, finite.front().world_T_robot, {0.10, 0.65, 0.20});
  DrawDisc(context, view, finite.back().world_T_robot, {0.85, 0.10, 0.10});
}

// In the strip below the map, from the middle of its width on: a sample of each kind of stretch.
void DrawLegend(cairo_t* context, const Stretches& stretches, const View& view) {
  double x = view.width_px() / 2.0;
  const double y = view.height_px() + kLegendHeightPx - 18.0;
  for (const StretchStyle& style : kStretchStyles) {
    if (!Has(stretches, style.kind)) continue;
    cairo_move_to(context, x, y - 6.0);
    cairo_line_to(context, x + 40.0, y - 6.0);
    Stroke(context, style);
    cairo_set_source_rgb(context, 0.15, 0.15, 0.15);
    cairo_move_to(context, x + 50.0, y + 2.0);
    cairo_show_text(context, style.kind);
    x += 180.0;
  }
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

void WriteMapPicture(const TrinaryMap& map, const Trajectory& trajectory,
                     const std::string& png_path, const Stretches& stretches) {
  const View view = Fit(map, trajectory);
  const PngCanvas canvas(view.width_px(), view.height_px() + kLegendHeightPx);
  if (cairo_surface_status(canvas.surface()) == CAIRO_STATUS_SUCCESS) {
    PaintMap(canvas.surface(), map, view);
  }
  DrawTrajectory(canvas.context(), trajectory, stretches, view);
  DrawScaleBar(canvas.context(), view);
  DrawLegend(canvas.context(), stretches, view);
  canvas.Write(png_path);
}

}  // namespace gmapping_spa::apps
