#include "experiments/metrics/wall_band.h"

#include "experiments/metrics/grid_ray.h"
#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {

std::optional<WallBand> FindWallBand(const map::TrinaryMap& map, const Eigen::Vector2d& surface,
                                     const Eigen::Vector2d& normal, double behind_m,
                                     double in_front_m) {
  const Eigen::Vector2d start = ToCells(map, surface - behind_m * normal);
  std::optional<WallBand> nearest, current;
  const auto end_current = [&] {
    if (current && (!nearest || current->distance_m() < nearest->distance_m())) nearest = current;
    current.reset();
  };
  const auto visit = [&](int column, int row, double begin, double end) {
    constexpr double kTouch = 1e-6;  // of a cell: less is a corner, not a gap in the band
    if (end - begin < kTouch) return true;
    if (StateAt(map, column, row) != map::CellState::kOccupied) {
      end_current();
      return true;
    }
    if (!current) current = WallBand{begin * map.resolution_m - behind_m, 0.0};
    current->end_m = end * map.resolution_m - behind_m;
    return true;
  };
  VisitCellsAlong(start, normal, (behind_m + in_front_m) / map.resolution_m, visit);
  end_current();
  return nearest;
}

}  // namespace gmapping_spa::metrics
