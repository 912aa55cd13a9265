// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/corner_errors.h"

#include <algorithm>
#include <cmath>

#include "experiments/metrics/cell_raster.h"
#include "experiments/metrics/closing.h"
#include "experiments/metrics/harris_corners.h"
#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

constexpr double kMinCell_m = 0.05;
constexpr double kClosing_m = 0.15;
// Of the strength of a wide wall's corner. A true corner counts as drawn when the map has so much
// as a faint one there, for the ragged edges of its walls weaken it.
constexpr double kShare = 0.5, kFaintShare = 0.3;
constexpr double kBeside_m = 0.1;  // of a corner are cells up to here
constexpr int kDetectorCells = 3;  // its reach

using Points = std::vector<Eigen::Vector2d>;

bool HasNear(const Points& points, const Eigen::Vector2d& point, double reach_m = kCornerReach_m) {
  return std::any_of(points.begin(), points.end(), [&](const Eigen::Vector2d& other) {
    return IsWithin((other - point).norm(), reach_m);
  });
}

// Whether surface that faces two ways is in sight there.
bool IsInSight(const std::vector<SurfaceElement>& surface, const Eigen::Vector2d& corner) {
  unsigned sides = 0;
  for (const SurfaceElement& element : surface) {
    if (IsWithin((element.middle() - corner).norm(), kCornerReach_m)) sides |= 1U << element.side;
  }
  return (sides & (sides - 1)) != 0;  // more than one
}

}  // namespace

CornerErrors FindCornerErrors(const map::TrinaryMap& truth, const MapComparison& comparison,
                              double tolerance_m) {
  const Eigen::Vector2d corner(truth.origin_x_m, truth.origin_y_m);
  const double cell_m =
      std::max({comparison.truth_resolution_m, comparison.map_resolution_m, kMinCell_m});
  const int closing = static_cast<int>(std::lround(kClosing_m / cell_m));
  const auto corners_of = [&](const Points& occupied, double min_share) {
    const map::TrinaryMap raster = Rasterize(occupied, corner, cell_m);
    return FindCorners(Closed(Framed(raster, closing + kDetectorCells), closing), min_share);
  };
  Points occupied, off_surface;
  for (const ComparedCell& cell : comparison.cells) {
    occupied.push_back(cell.center);
    if (!IsWithin(cell.distance_m, tolerance_m)) off_surface.push_back(cell.center);
  }
  const Points true_corners = corners_of(OccupiedCenters(truth), kShare);
  const Points faint_corners = corners_of(occupied, kFaintShare);
  CornerErrors errors;
  for (const Eigen::Vector2d& point : true_corners) {
    if (!IsInSight(comparison.surface, point)) continue;
    errors.in_sight.push_back(point);
    errors.found += HasNear(faint_corners, point);
  }
  for (const Eigen::Vector2d& point : corners_of(occupied, kShare)) {
    if (HasNear(off_surface, point, kBeside_m) && !HasNear(true_corners, point))
      errors.false_ones.push_back(point);
  }
  return errors;
}

}  // namespace gmapping_spa::metrics
