// SPDX-License-Identifier: BSD-3-Clause
// The band of occupied cells that a map has where there is a wall.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_BAND_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_BAND_H_

#include <Eigen/Core>
#include <vector>

#include "experiments/metrics/true_surface.h"
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

// The bands across the stretch of wall around `surface`, a point in the frame of the map, as is the
// normal of `across`. Lines along the normal, a cell of the map apart, cover the stretch and reach
// as far as `across` says; where any of them is in an occupied cell, there is band. The band
// nearest to the surface, which is the wall, comes first, the others from behind to the front. They
// do not touch each other.
std::vector<WallBand> FindWallBands(const map::TrinaryMap& map, const Eigen::Vector2d& surface,
                                    const Across& across);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_BAND_H_
