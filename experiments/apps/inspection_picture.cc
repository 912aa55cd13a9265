// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/inspection_picture.h"

#include <cairo.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <vector>

#include "experiments/apps/png_canvas.h"

namespace gmapping_spa::apps {
namespace {

using backend::SE2;
using Eigen::Vector2d;

constexpr int kWidth_px = 1600, kHeight_px = 1200;

// Where a plot stands, in pixels of the page.
struct Frame {
  double left, top, width, height;
};
constexpr Frame kWay{60, 50, 800, 680}, kHistogram{960, 50, 580, 680}, kLengths{60, 790, 1480, 150},
    kTurns{60, 1000, 1480, 150};

struct Box {
  Vector2d min = Vector2d::Constant(INFINITY), max = -min;

  void Add(const Vector2d& point) {
    if (!point.allFinite()) return;
    min = min.cwiseMin(point);
    max = max.cwiseMax(point);
  }
  bool empty() const { return !(min.x() <= max.x()); }
};

std::string Number(double value) {
  std::ostringstream out;
  out << std::setprecision(6) << value;
  return out.str();
}

void Text(cairo_t* cairo, double x, double y, const std::string& text) {
  cairo_move_to(cairo, x, y);
  cairo_show_text(cairo, text.c_str());
}

// A plot: its frame with a title, and the map of its coordinates to pixels.
class Plot {
 public:
  Plot(cairo_t* cairo, const Frame& frame, Box box, const std::string& title, bool equal_scales)
      : cairo_(cairo), frame_(frame), box_(box) {
    // A plot of one point or one line has an extent, too.
    const Vector2d missing = (Vector2d::Constant(1e-3) - (box_.max - box_.min)).cwiseMax(0.0);
    box_.min -= missing / 2.0;
    box_.max += missing / 2.0;
    if (equal_scales) {
      const Vector2d size(frame.width, frame.height);
      const double m_per_px = (box_.max - box_.min).cwiseQuotient(size).maxCoeff();
      const Vector2d center = (box_.min + box_.max) / 2.0;
      box_.min = center - size * m_per_px / 2.0;
      box_.max = center + size * m_per_px / 2.0;
    }
    cairo_set_source_rgb(cairo, 0.15, 0.15, 0.15);
    cairo_set_line_width(cairo, 1.0);
    cairo_rectangle(cairo, frame.left, frame.top, frame.width, frame.height);
    cairo_stroke(cairo);
    Text(cairo, frame.left, frame.top - 10,
         title + ", upward from " + Number(box_.min.y()) + " to " + Number(box_.max.y()));
    Text(cairo, frame.left, frame.top + frame.height + 20, Number(box_.min.x()));
    Text(cairo, frame.left + frame.width - 60, frame.top + frame.height + 20, Number(box_.max.x()));
  }

  double Column(double x) const {
    return frame_.left + (x - box_.min.x()) / (box_.max.x() - box_.min.x()) * frame_.width;
  }
  double Row(double y) const {
    return frame_.top + (box_.max.y() - y) / (box_.max.y() - box_.min.y()) * frame_.height;
  }
  void Dot(const Vector2d& point, double size_px) const {
    if (!point.allFinite()) return;
    cairo_rectangle(cairo_, Column(point.x()) - size_px / 2, Row(point.y()) - size_px / 2, size_px,
                    size_px);
    cairo_fill(cairo_);
  }
  cairo_t* cairo() const { return cairo_; }

 private:
  cairo_t* cairo_;
  Frame frame_;
  Box box_;
};

std::vector<Vector2d> EndsOfBeams(const sensor::LaserScan& scan) {
  const SE2 odom_T_laser = scan.odom_T_robot * scan.robot_T_laser;
  std::vector<Vector2d> ends;
  for (const sensor::Beam& beam : scan.beams) {
    if (beam.status != sensor::BeamStatus::kHit) continue;
    ends.push_back(odom_T_laser * Vector2d(beam.range_m * std::cos(beam.angle_rad),
                                           beam.range_m * std::sin(beam.angle_rad)));
  }
  return ends;
}

void DrawWay(cairo_t* cairo, const LogSummary& summary) {
  Box box;
  for (const SE2& pose : summary.odom_T_robot) box.Add(pose.translation());
  std::vector<Vector2d> ends;
  for (const sensor::LaserScan& scan : summary.samples) {
    if (!scan.has_odometry) continue;
    for (const Vector2d& end : EndsOfBeams(scan)) ends.push_back(end);
  }
  for (const Vector2d& end : ends) box.Add(end);
  if (box.empty()) box.Add(Vector2d::Zero());
  const Plot plot(cairo, kWay, box, "way of the odometry, and some scans (m)", true);
  cairo_set_source_rgb(cairo, 0.45, 0.45, 0.45);
  for (const Vector2d& end : ends) plot.Dot(end, 1.5);
  cairo_set_source_rgb(cairo, 0.10, 0.25, 0.85);
  for (const SE2& pose : summary.odom_T_robot) plot.Dot(pose.translation(), 2.0);
}

void DrawHistogram(cairo_t* cairo, const LogSummary& summary) {
  const std::vector<std::int64_t>& hits = summary.hits_by_meter;
  const double most =
      hits.empty() ? 1.0 : static_cast<double>(*std::max_element(hits.begin(), hits.end()));
  Box box;
  box.Add(Vector2d::Zero());
  box.Add({std::max<double>(1.0, static_cast<double>(hits.size())), most});
  const Plot plot(cairo, kHistogram, box, "beams by range (m)", false);
  cairo_set_source_rgb(cairo, 0.00, 0.55, 0.55);
  for (std::size_t meter = 0; meter < hits.size(); ++meter) {
    const double from = static_cast<double>(meter), top = static_cast<double>(hits[meter]);
    cairo_rectangle(cairo, plot.Column(from), plot.Row(top),
                    plot.Column(from + 1.0) - plot.Column(from) - 1.0,
                    plot.Row(0.0) - plot.Row(top));
    cairo_fill(cairo);
  }
}

void DrawSteps(cairo_t* cairo, const LogSummary& summary, const Frame& frame,
               const std::string& title, double (*value)(const OdometryStep&)) {
  Box box;
  box.Add(Vector2d::Zero());
  box.Add({summary.last_stamp_s - summary.first_stamp_s, 0.0});
  const auto point = [&](const OdometryStep& step) {
    return Vector2d(step.stamp_s - summary.first_stamp_s, value(step));
  };
  for (const OdometryStep& step : summary.steps) box.Add(point(step));
  const Plot plot(cairo, frame, box, title, false);
  for (const bool fault : {false, true}) {  // faults above the others
    cairo_set_source_rgb(cairo, fault ? 0.85 : 0.10, fault ? 0.10 : 0.25, fault ? 0.10 : 0.85);
    for (const OdometryStep& step : summary.steps) {
      const bool is_fault = step.fault != sensor::OdometryFault::kNone &&
                            step.fault != sensor::OdometryFault::kUnchanged;
      if (is_fault == fault) plot.Dot(point(step), fault ? 6.0 : 2.0);
    }
  }
}

}  // namespace

void WriteInspectionPicture(const LogSummary& summary, const std::string& png_path) {
  const PngCanvas canvas(kWidth_px, kHeight_px);
  cairo_t* const cairo = canvas.context();
  cairo_set_source_rgb(cairo, 1.0, 1.0, 1.0);
  cairo_paint(cairo);
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);  // dots of few pixels in their full color
  // Cairo's built-in font: the same picture on every machine, whatever fonts it has.
  cairo_select_font_face(cairo, "@cairo:", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, 16.0);
  DrawWay(cairo, summary);
  DrawHistogram(cairo, summary);
  DrawSteps(cairo, summary, kLengths, "length of the odometry's steps (m) over time (s)",
            [](const OdometryStep& step) { return step.length_m; });
  DrawSteps(cairo, summary, kTurns, "turn of the odometry's steps (deg) over time (s)",
            [](const OdometryStep& step) { return step.turn_rad * 180.0 / std::numbers::pi; });
  canvas.Write(png_path);
}

}  // namespace gmapping_spa::apps
