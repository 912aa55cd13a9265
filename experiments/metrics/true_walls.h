// SPDX-License-Identifier: BSD-3-Clause
// Straight true surface, put together to walls.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_TRUE_WALLS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_TRUE_WALLS_H_

#include <cstddef>
#include <functional>
#include <vector>

#include "experiments/metrics/true_surface.h"

namespace gmapping_spa::metrics {

// Elements of surface, by their indices in ascending order, that are one stretch.
using Stretch = std::vector<std::size_t>;

// What is shorter than this is no wall, true or drawn.
inline constexpr double kMinWall_m = 0.3;

// Joins straight elements of which `counts` is true to stretches: two of them belong together when
// their middles are at most 3.5 cells apart and their normals at most 30 degrees. So a wall goes on
// past an element or two that were not in sight, and ends at corners, doors and steps.
std::vector<Stretch> JoinElements(const std::vector<SurfaceElement>& surface, double resolution_m,
                                  const std::function<bool(std::size_t)>& counts);

// Along the wall; that of an element is less than its edge where the wall is slanted.
double Length_m(const std::vector<SurfaceElement>& surface, const Stretch& stretch);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_TRUE_WALLS_H_
