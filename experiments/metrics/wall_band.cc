// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/wall_band.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "experiments/metrics/grid_ray.h"
#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {

std::vector<WallBand> FindWallBands(const map::TrinaryMap& map, const Eigen::Vector2d& surface,
                                    const Across& across) {
  constexpr double kTouchCells = 1e-6;  // what rounding makes of two cells side by side
  const Eigen::Vector2d along(-across.normal.y(), across.normal.x());
  const int lines = static_cast<int>(across.half_length_m / map.resolution_m + kTouchCells);
  std::vector<WallBand> pieces;
  for (int line = -lines; line <= lines; ++line) {
    const Eigen::Vector2d start =
        surface + line * map.resolution_m * along - across.behind_m * across.normal;
    VisitCellsAlong(
        ToCells(map, start), across.normal,
        (across.behind_m + across.in_front_m) / map.resolution_m,
        [&](int column, int row, double begin, double end) {
          if (end - begin > kTouchCells && StateAt(map, column, row) == map::CellState::kOccupied) {
            pieces.push_back({begin * map.resolution_m - across.behind_m,
                              end * map.resolution_m - across.behind_m});
          }
          return true;
        });
  }
  std::sort(pieces.begin(), pieces.end(),
            [](const WallBand& a, const WallBand& b) { return a.begin_m < b.begin_m; });
  std::vector<WallBand> bands;
  for (const WallBand& piece : pieces) {
    if (bands.empty() || piece.begin_m > bands.back().end_m + kTouchCells * map.resolution_m) {
      bands.push_back(piece);
    } else {
      bands.back().end_m = std::max(bands.back().end_m, piece.end_m);
    }
  }
  const auto nearest = std::min_element(
      bands.begin(), bands.end(),
      [](const WallBand& a, const WallBand& b) { return a.distance_m() < b.distance_m(); });
  if (nearest != bands.end()) std::rotate(bands.begin(), nearest, std::next(nearest));
  return bands;
}

}  // namespace gmapping_spa::metrics
