// SPDX-License-Identifier: BSD-3-Clause
// How a map draws single objects of the world, such as the obstacles of an experiment.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_OBJECT_ERRORS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_OBJECT_ERRORS_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "experiments/metrics/map_comparison.h"
#include "frontend/map/trinary_map.h"

namespace gmapping_spa::metrics {

struct ObjectErrors {
  Eigen::Vector2d center;          // of the smallest upright rectangle around it, in the true frame
  double surface_m = 0.0;          // in sight, by the edges of cells
  std::optional<double> complete;  // part of that within the tolerance of an occupied cell
  std::optional<double> width_m;   // mean width of the bands across what is drawn and straight
  // Half of what is in sight is drawn.
  bool is_there() const { return complete && *complete >= 0.5; }
};

// `objects` is in the grid of the true map, occupied where the true map is for them: each set of
// occupied cells that share edges or corners is an object. In the order of their lowest cells.
// Throws std::runtime_error when the grids differ or an occupied cell is not so in the true map.
std::vector<ObjectErrors> FindObjectErrors(const map::TrinaryMap& truth,
                                           const map::TrinaryMap& objects,
                                           const MapComparison& comparison, double tolerance_m);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_OBJECT_ERRORS_H_
