// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/ghost_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "experiments/metrics/cell_raster.h"
#include "experiments/metrics/closing.h"
#include "experiments/metrics/connected_cells.h"
#include "experiments/metrics/map_cells.h"
#include "experiments/metrics/thinning.h"
#include "experiments/metrics/true_walls.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

// Takes out of the raster what is a true wall in another place.
void RemoveShiftedWalls(const MapComparison& comparison, double tolerance_m, TrinaryMap* raster) {
  const double step_m = 0.5 * raster->resolution_m;
  for (std::size_t i = 0; i < comparison.surface.size(); ++i) {
    const auto& bands = comparison.elements[i].bands;
    if (bands.empty() || IsWithin(bands.front().distance_m(), tolerance_m)) continue;
    const SurfaceElement& element = comparison.surface[i];
    const WallBand& band = bands.front();
    // Around the band, which need not lie along the rows of the raster.
    for (double away_m = band.begin_m - step_m; away_m <= band.end_m + step_m; away_m += step_m) {
      for (const double share : {0.0, 0.5, 1.0}) {
        const Eigen::Vector2d on_edge =
            element.edge.from + share * (element.edge.to - element.edge.from);
        const Eigen::Vector2d cell = ToCells(*raster, on_edge + away_m * element.across->normal);
        const int column = CellOf(cell.x()), row = CellOf(cell.y());
        if (StateAt(*raster, column, row) == CellState::kOccupied) {
          raster->at(column, row) = CellState::kFree;
        }
      }
    }
  }
}

// Of a line of one cell with branches: the steps from cell to cell, straight or diagonal.
double Length_m(const TrinaryMap& lines, const std::vector<std::array<int, 2>>& cells) {
  const auto is_line = [&](int column, int row) {
    return StateAt(lines, column, row) == CellState::kOccupied;
  };
  double steps = 0.0;  // each counts half from either of its cells
  for (const auto& [column, row] : cells) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || !is_line(column + dx, row + dy)) continue;
        const bool two_straight_steps_lead_there =
            dx != 0 && dy != 0 && (is_line(column + dx, row) || is_line(column, row + dy));
        if (!two_straight_steps_lead_there) steps += 0.5 * std::hypot(dx, dy);
      }
    }
  }
  return (steps + 1.0) * lines.resolution_m;  // n cells in a row are n cells long
}

}  // namespace

std::vector<GhostWall> FindGhostWalls(const MapComparison& comparison, double tolerance_m) {
  std::vector<Eigen::Vector2d> off;
  for (const ComparedCell& cell : comparison.cells) {
    if (!IsWithin(cell.distance_m, tolerance_m)) off.push_back(cell.center);
  }
  const double cell_m = std::max(comparison.truth_resolution_m, comparison.map_resolution_m);
  TrinaryMap raster = Rasterize(off, Eigen::Vector2d::Zero(), cell_m);
  RemoveShiftedWalls(comparison, tolerance_m, &raster);
  const TrinaryMap lines = Thinned(Closed(Framed(raster, 1), 1));
  std::vector<GhostWall> walls;
  for (const auto& cells : ConnectedCells(lines)) {
    GhostWall wall{.length_m = Length_m(lines, cells), .points = {}};
    if (!IsWithin(kMinWall_m, wall.length_m)) continue;
    for (const auto& [column, row] : cells) wall.points.push_back(CellCenter(lines, column, row));
    walls.push_back(std::move(wall));
  }
  return walls;
}

}  // namespace gmapping_spa::metrics
