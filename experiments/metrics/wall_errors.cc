// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/wall_errors.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "experiments/metrics/cell_raster.h"
#include "experiments/metrics/map_cells.h"
#include "experiments/metrics/true_walls.h"

namespace gmapping_spa::metrics {
namespace {

constexpr double kRounding_m = 1e-9;  // lengths are sums of edges

bool IsDrawn(const ComparedElement& element, double tolerance_m) {
  return !element.bands.empty() || IsWithin(element.distance_m, tolerance_m);
}

// Whether a cell of a ghost lies in the band or beside it.
bool HoldsGhost(const map::TrinaryMap& ghosts, const SurfaceElement& element,
                const WallBand& band) {
  const double step_m = 0.5 * ghosts.resolution_m;
  for (double away_m = band.begin_m; away_m <= band.end_m; away_m += step_m) {
    const Eigen::Vector2d cell =
        ToCells(ghosts, element.middle() + away_m * element.across->normal);
    const int column = CellOf(cell.x()), row = CellOf(cell.y());
    for (int y = row - 1; y <= row + 1; ++y) {
      for (int x = column - 1; x <= column + 1; ++x) {
        if (StateAt(ghosts, x, y) == map::CellState::kOccupied) return true;
      }
    }
  }
  return false;
}

bool IsDoubled(const map::TrinaryMap& ghosts, const SurfaceElement& element,
               const std::vector<WallBand>& bands) {
  if (bands.empty()) return false;
  const WallBand& wall = bands.front();
  return std::any_of(bands.begin() + 1, bands.end(), [&](const WallBand& other) {
    const double between_m = std::max(other.begin_m - wall.end_m, wall.begin_m - other.end_m);
    return IsWithin(kMinApart_m, between_m) && HoldsGhost(ghosts, element, other);
  });
}

}  // namespace

WallErrors FindWallErrors(const MapComparison& comparison, const std::vector<GhostWall>& ghosts,
                          double tolerance_m) {
  const auto& surface = comparison.surface;
  const auto join = [&](const auto& counts) {
    return JoinElements(surface, comparison.truth_resolution_m, counts);
  };
  const auto drawn = [&](std::size_t i) { return IsDrawn(comparison.elements[i], tolerance_m); };
  WallErrors errors;
  constexpr int kNone = -1;
  std::vector<int> wall_of(surface.size(), kNone);
  for (const Stretch& wall : join([](std::size_t) { return true; })) {
    const double length_m = Length_m(surface, wall);
    if (length_m < kMinWall_m - kRounding_m) continue;
    Stretch found;
    std::copy_if(wall.begin(), wall.end(), std::back_inserter(found), drawn);
    const bool missing = Length_m(surface, found) < 0.5 * length_m;
    for (const std::size_t i : wall) wall_of[i] = missing ? kNone : errors.walls;
    errors.missing_walls += missing;
    errors.walls_m += length_m;
    ++errors.walls;
  }
  std::vector<bool> broken(errors.walls, false);
  const auto is_gap = [&](std::size_t i) { return wall_of[i] != kNone && !drawn(i); };
  for (const Stretch& gap : join(is_gap)) {
    const double length_m = Length_m(surface, gap);
    if (length_m < kMinGap_m - kRounding_m) continue;
    broken[wall_of[gap.front()]] = true;
    errors.gaps_m += length_m;
    ++errors.gaps;
  }
  errors.broken_walls = static_cast<int>(std::count(broken.begin(), broken.end(), true));

  std::vector<Eigen::Vector2d> points;
  for (const GhostWall& ghost : ghosts) {
    points.insert(points.end(), ghost.points.begin(), ghost.points.end());
  }
  const map::TrinaryMap raster =
      Rasterize(points, Eigen::Vector2d::Zero(),
                std::max(comparison.truth_resolution_m, comparison.map_resolution_m));
  const auto doubled = [&](std::size_t i) {
    return IsDoubled(raster, surface[i], comparison.elements[i].bands);
  };
  for (const Stretch& stretch : join(doubled)) {
    const double length_m = Length_m(surface, stretch);
    if (length_m < kMinWall_m - kRounding_m) continue;
    errors.doubled_walls_m += length_m;
    ++errors.doubled_walls;
  }
  return errors;
}

}  // namespace gmapping_spa::metrics
