// SPDX-License-Identifier: BSD-3-Clause
// The surface of what stands in a true map: where the beams of a laser end.
//
// A wall cell of the true map is solid, and its surface is the edge that it shares with free space.
// A mapper puts its hits there, half a cell in front of the center of the wall cell; measured from
// centres, a map without error would be half a cell wrong. So everything is measured from edges.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_TRUE_SURFACE_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_TRUE_SURFACE_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "experiments/metrics/cell_distance.h"
#include "experiments/metrics/map_cells.h"
#include "experiments/metrics/seen_space.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// Around a point of straight surface: how far this is the nearest surface.
struct Across {
  Eigen::Vector2d normal;      // unit, into free space
  double half_length_m = 0.0;  // along the wall, to both sides
  double behind_m = 0.0;       // half way to the seen free space behind the wall
  double in_front_m = 0.0;     // half way to the next thing in front
};

// One edge of one cell, in the frame of the true map.
struct SurfaceElement {
  int column = 0, row = 0;  // the occupied cell
  int side = 0;             // kSides[side] leads to the free cell
  Segment edge;

  Eigen::Vector2d middle() const { return 0.5 * (edge.from + edge.to); }

  std::optional<Across> across;  // only where the surface is straight
};

// What is farther than this from a surface has nothing to do with it.
inline constexpr double kReach_m = 0.5;

// Calls visit(side, edge) for the edges between an occupied cell of the true map and free ones.
template <typename Visit>
void VisitSurface(const map::TrinaryMap& truth, int column, int row, const Visit& visit) {
  if (truth.at(column, row) != map::CellState::kOccupied) return;
  const Eigen::Vector2d center = CellCenter(truth, column, row);
  const double half = 0.5 * truth.resolution_m;
  for (int side = 0; side < 4; ++side) {
    const auto [dx, dy] = kSides[side];
    if (StateAt(truth, column + dx, row + dy) != map::CellState::kFree) continue;
    const Eigen::Vector2d middle = center + half * Eigen::Vector2d(dx, dy);
    const Eigen::Vector2d along = half * Eigen::Vector2d(-dy, dx);
    visit(side, Segment{middle - along, middle + along});
  }
}

// Every edge between an occupied cell and a free one at which sight ended, by rows and columns of
// occupied cells. The surface is straight at an edge when the edges around it, seen or not, within
// three cells and not facing the other way, reach two cells or more to both sides and lie within
// 0.6 cells of their line of least squares. `across` reaches kReach_m at most.
std::vector<SurfaceElement> FindSeenSurface(const map::TrinaryMap& truth, const SeenSpace& seen);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_TRUE_SURFACE_H_
