// SPDX-License-Identifier: BSD-3-Clause
// A map laid over the true one: what each item of either is away from the other.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_COMPARISON_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_COMPARISON_H_

#include <Eigen/Core>
#include <vector>

#include "backend/se2.h"
#include "experiments/metrics/seen_space.h"
#include "experiments/metrics/true_surface.h"
#include "experiments/metrics/wall_band.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

// Distances are not looked for beyond this, which stands for all larger ones.
inline constexpr double kDistanceCap_m = 1.0;

// Limits often are multiples of a cell, as distances are; rounding must not decide.
inline bool IsWithin(double distance_m, double limit_m) { return distance_m <= limit_m + 1e-9; }

// An occupied cell of the map.
struct ComparedCell {
  Eigen::Vector2d center;   // in the frame of the true map
  double distance_m = 0.0;  // from the cell, a square, to the nearest true surface, seen or not
  bool in_seen_space = false;
};

// A SurfaceElement.
struct ComparedElement {
  double distance_m = 0.0;      // from its middle to the nearest occupied cell, 0 in it
  std::vector<WallBand> bands;  // across straight surface, that of the wall first
};

struct MapComparison {
  SeenSpace seen;
  std::vector<SurfaceElement> surface;
  std::vector<ComparedElement> elements;  // as long as `surface`
  std::vector<ComparedCell> cells;        // by rows and columns of the map
  int seen_cells = 0;
  int known_cells = 0;  // seen cells whose centres the map does not call unknown
  double truth_resolution_m = 0.05, map_resolution_m = 0.05;
};

// `truth_T_map` lays the frame of the map over that of the truth.
MapComparison CompareMaps(const map::TrinaryMap& truth, const SeenSpace& seen,
                          const map::TrinaryMap& map, const backend::SE2& truth_T_map);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_MAP_COMPARISON_H_
