// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/map_comparison.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>

#include "experiments/metrics/cell_distance.h"
#include "experiments/metrics/map_cells.h"
#include "experiments/metrics/ring_search.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

constexpr double kFar = std::numeric_limits<double>::infinity();

std::vector<ComparedElement> CompareElements(const std::vector<SurfaceElement>& surface,
                                             const TrinaryMap& map,
                                             const backend::SE2& map_T_truth) {
  const backend::SE2 rotation{0.0, 0.0, map_T_truth.theta};
  std::vector<ComparedElement> elements;
  for (const SurfaceElement& element : surface) {
    const Eigen::Vector2d middle = map_T_truth * element.middle();
    const auto distance = [&](int column, int row) {
      if (map.at(column, row) != CellState::kOccupied) return kFar;
      return Distance(Square{CellCenter(map, column, row), 0.5 * map.resolution_m}, middle);
    };
    ComparedElement& compared = elements.emplace_back();
    compared.distance_m = SearchRings(map, middle, kDistanceCap_m, 0.0, distance);
    if (!element.across) continue;
    Across across = *element.across;
    across.normal = rotation * across.normal;
    compared.bands = FindWallBands(map, middle, across);
  }
  return elements;
}

std::vector<ComparedCell> CompareCells(const TrinaryMap& truth, const SeenSpace& seen,
                                       const TrinaryMap& map, const backend::SE2& truth_T_map) {
  const backend::SE2 map_T_truth = Inverse(truth_T_map);
  std::vector<ComparedCell> cells;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) != CellState::kOccupied) continue;
      const Square square{CellCenter(map, column, row), 0.5 * map.resolution_m};
      const auto distance = [&](int true_column, int true_row) {
        double nearest = kFar;
        VisitSurface(truth, true_column, true_row, [&](int, const Segment& edge) {
          const Segment map_edge{map_T_truth * edge.from, map_T_truth * edge.to};
          nearest = std::min(nearest, Distance(square, map_edge));
        });
        return nearest;
      };
      const Eigen::Vector2d center = truth_T_map * square.center;
      const double half_diagonal = square.half_side * std::numbers::sqrt2;
      const Eigen::Vector2d true_cell = ToCells(truth, center);
      cells.push_back(
          {.center = center,
           .distance_m = SearchRings(truth, center, kDistanceCap_m, half_diagonal, distance),
           .in_seen_space = seen.IsSeen(CellOf(true_cell.x()), CellOf(true_cell.y()))});
    }
  }
  return cells;
}

}  // namespace

MapComparison CompareMaps(const TrinaryMap& truth, const SeenSpace& seen, const TrinaryMap& map,
                          const backend::SE2& truth_T_map) {
  const backend::SE2 map_T_truth = Inverse(truth_T_map);
  MapComparison comparison;
  comparison.seen = seen;
  comparison.surface = FindSeenSurface(truth, seen);
  comparison.elements = CompareElements(comparison.surface, map, map_T_truth);
  comparison.cells = CompareCells(truth, seen, map, truth_T_map);
  comparison.truth_resolution_m = truth.resolution_m;
  comparison.map_resolution_m = map.resolution_m;
  for (int row = 0; row < truth.height; ++row) {
    for (int column = 0; column < truth.width; ++column) {
      if (!seen.IsSeen(column, row)) continue;
      ++comparison.seen_cells;
      const Eigen::Vector2d cell = ToCells(map, map_T_truth * CellCenter(truth, column, row));
      comparison.known_cells +=
          StateAt(map, CellOf(cell.x()), CellOf(cell.y())) != CellState::kUnknown;
    }
  }
  return comparison;
}

}  // namespace gmapping_spa::metrics
