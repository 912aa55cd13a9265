#include "experiments/metrics/wall_band.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "experiments/metrics/grid_ray.h"
#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {

std::optional<WallBand> FindWallBand(const map::TrinaryMap& map, const Eigen::Vector2d& surface,
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
  std::optional<WallBand> nearest;
  for (std::size_t i = 0; i < pieces.size();) {
    WallBand band = pieces[i++];
    while (i < pieces.size() && pieces[i].begin_m <= band.end_m + kTouchCells * map.resolution_m) {
      band.end_m = std::max(band.end_m, pieces[i++].end_m);
    }
    if (!nearest || band.distance_m() < nearest->distance_m()) nearest = band;
  }
  return nearest;
}

}  // namespace gmapping_spa::metrics
