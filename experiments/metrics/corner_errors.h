// SPDX-License-Identifier: BSD-3-Clause
// Which true corners a map draws, and which it draws that are not there.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_CORNER_ERRORS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_CORNER_ERRORS_H_

#include <Eigen/Core>
#include <vector>

#include "experiments/metrics/map_comparison.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// Corners of harris_corners.h, in the frame of the true map. Both maps are looked at in the same
// grid, with the cells of the coarser of them but not below 0.05 m, for the detector sees cells
// only; and after a closing that fills walls of up to 0.3 m between their two faces.
struct CornerErrors {
  std::vector<Eigen::Vector2d> in_sight;  // true ones with surface in sight on two sides
  int found = 0;                          // of these, with a corner of the map nearby
  std::vector<Eigen::Vector2d>
      false_ones;  // of the map, off the true surface, with no true one nearby
};

// Nearby is as far as this.
inline constexpr double kCornerReach_m = 0.2;
CornerErrors FindCornerErrors(const map::TrinaryMap& truth, const MapComparison& comparison,
                              double tolerance_m);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_CORNER_ERRORS_H_
