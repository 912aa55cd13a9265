// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/trajectory_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

namespace gmapping_spa::apps {
namespace {

using backend::StampedPose;
using backend::Trajectory;
using View = PictureView;

struct Color {
  double red, green, blue;
};

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

}  // namespace

void DrawTrajectory(cairo_t* context, const Trajectory& trajectory, const Stretches& stretches,
                    const PictureView& view) {
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

void DrawStretchLegend(cairo_t* context, const Stretches& stretches, double x, double y) {
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

}  // namespace gmapping_spa::apps
