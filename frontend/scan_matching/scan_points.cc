// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/scan_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "frontend/sensor/deskew.h"

namespace gmapping_spa::scan_matching {

namespace {

// Two neighboring beams meet one surface where their end points are no farther apart than this
// many times what they would be across the beams: that is, if it is not met at too flat an angle.
constexpr double kFlattest = 4.0;
constexpr double kMaxGap_m = 1.0;
// The surface is looked at this far to either side, so that the noise of the ranges does not turn
// its normal, and is smooth where the point is so near to the line between the ends, as a part of
// their distance and at least.
constexpr double kReach_m = 0.15;
constexpr double kSmooth = 0.1;
constexpr double kSmooth_m = 0.03;

// Beams that end farther apart than this, as seen from the laser, count in full.
constexpr double kIndependent_m = 0.1;
constexpr double kLeastWeight = 0.1;  // or a covered laser would have no weight at all

constexpr double kRangeNoise_m = 0.015;  // standard deviation of common lasers

double SquaredDistance(const ScanPoint& a, const ScanPoint& b) {
  const double x = a.x_m - b.x_m, y = a.y_m - b.y_m;
  return x * x + y * y;
}

bool OnOneSurface(const ScanPoint& a, const ScanPoint& b) {
  const double across_m = a.range_m * std::abs(a.back_x * b.back_y - a.back_y * b.back_x);
  const double limit_m = std::clamp(kFlattest * across_m, kSmooth_m, kMaxGap_m);
  return SquaredDistance(a, b) <= limit_m * limit_m;
}

// Between neighboring beams, on average; rad.
double AngleBetweenBeams(const std::vector<sensor::Beam>& beams) {
  if (beams.size() < 2) return 2.0 * std::numbers::pi;
  return std::abs(beams.back().angle_rad - beams.front().angle_rad) /
         static_cast<double>(beams.size() - 1);
}

// From the neighbors that meet the same surface: both, if they agree with the point, else the
// nearer one.
void SetNormal(const ScanPoint* before, const ScanPoint* after, ScanPoint* point) {
  if (!before && !after) return;
  const ScanPoint& from = before ? *before : *point;
  const ScanPoint& to = after ? *after : *point;
  const double x = to.x_m - from.x_m, y = to.y_m - from.y_m;
  const double length_m = std::sqrt(x * x + y * y);
  if (length_m < 1e-6) return;
  const double normal_x = -y / length_m, normal_y = x / length_m;
  const double off_m = normal_x * (point->x_m - from.x_m) + normal_y * (point->y_m - from.y_m);
  if (std::abs(off_m) > std::max(kSmooth * length_m, kSmooth_m)) return;
  point->normal_x = normal_x;
  point->normal_y = normal_y;
  const double noise_m = kRangeNoise_m * (normal_x * point->back_x + normal_y * point->back_y);
  point->normal_variance = 2.0 * noise_m * noise_m / (length_m * length_m);
}

}  // namespace

ScanPoints MakeEndPoints(const sensor::LaserScan& scan) {
  ScanPoints points;
  points.reserve(scan.beams.size());
  const backend::SE2& mount = scan.robot_T_laser;
  const double weight_per_m = AngleBetweenBeams(scan.beams) / kIndependent_m;
  for (std::size_t k = 0; k < scan.beams.size(); ++k) {
    const sensor::Beam& beam = scan.beams[k];
    if (beam.status != sensor::BeamStatus::kHit) continue;
    const double c = std::cos(mount.theta + beam.angle_rad);
    const double s = std::sin(mount.theta + beam.angle_rad);
    points.push_back({mount.x + beam.range_m * c, mount.y + beam.range_m * s, -c, -s, beam.range_m,
                      std::clamp(weight_per_m * beam.range_m, kLeastWeight, 1.0)});
    points.back().in_sweep = sensor::PlaceInSweep(scan, k);
  }
  return points;
}

ScanPoints MakeScanPoints(const sensor::LaserScan& scan) {
  ScanPoints points = MakeEndPoints(scan);
  std::vector<int> beams;  // their positions in the scan
  for (std::size_t k = 0; k < scan.beams.size(); ++k) {
    if (scan.beams[k].status == sensor::BeamStatus::kHit) beams.push_back(static_cast<int>(k));
  }
  // The farthest point in reach on the surface that goes on from point k in that direction; null
  // where the neighbor is not on it.
  const auto end_of_surface = [&](std::size_t k, std::size_t direction) {
    const ScanPoint* end = nullptr;
    for (std::size_t i = k; i + direction < points.size(); i += direction) {
      const ScanPoint& next = points[i + direction];
      if (std::abs(beams[i + direction] - beams[i]) > 1) break;
      if (!OnOneSurface(points[i], next)) break;
      if (end && SquaredDistance(next, points[k]) > kReach_m * kReach_m) break;
      end = &next;
    }
    return end;
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    SetNormal(end_of_surface(k, -1), end_of_surface(k, 1), &points[k]);
  }
  return points;
}

}  // namespace gmapping_spa::scan_matching
