// The band of occupied cells that a map has where there is a wall.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_BAND_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_BAND_H_

#include <Eigen/Core>
#include <optional>

#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// Where the band begins and ends along the normal of the wall: 0 is the surface, positive is in
// front of it. In metres.
struct WallBand {
  double begin_m = 0.0, end_m = 0.0;

  double width_m() const { return end_m - begin_m; }
  // From the surface to the nearest point of the band, 0 when the surface lies in it.
  double distance_m() const { return begin_m > 0.0 ? begin_m : end_m < 0.0 ? -end_m : 0.0; }
};

// The run of occupied cells nearest to `surface` on the line along `normal`, which reaches
// behind_m into the wall and in_front_m out of it; the band is cut off at its ends. Nothing when no
// cell of the line is occupied. Point and unit normal are in the frame of the map.
std::optional<WallBand> FindWallBand(const map::TrinaryMap& map, const Eigen::Vector2d& surface,
                                     const Eigen::Vector2d& normal, double behind_m,
                                     double in_front_m);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_BAND_H_
