// SPDX-License-Identifier: BSD-3-Clause
// Which true walls a map draws whole, with gaps, twice or not at all.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_ERRORS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_ERRORS_H_

#include <vector>

#include "experiments/metrics/ghost_walls.h"
#include "experiments/metrics/map_comparison.h"

namespace gmapping_spa::metrics {

// Of the true walls in sight: straight stretches of kMinWall_m or more.
struct WallErrors {
  int walls = 0;
  double walls_m = 0.0;
  int missing_walls = 0;  // less than half of them is drawn
  int broken_walls = 0;   // the others that have gaps
  int gaps = 0;           // of these
  double gaps_m = 0.0;
  int doubled_walls = 0;  // stretches of kMinWall_m or more that are drawn twice
  double doubled_walls_m = 0.0;
};

// A wall is drawn where an occupied cell is within the tolerance or a band lies across it, as far
// off as that may be: a wall that is shifted as a whole is not missing. A gap is a stretch of
// kMinGap_m or more that is not drawn; cells at both its ends cover some of it.
inline constexpr double kMinGap_m = 0.2;
// A wall is drawn twice where, across it, a ghost wall (of the same map) lies beside its band, with
// kMinApart_m or more between them.
inline constexpr double kMinApart_m = 0.1;
WallErrors FindWallErrors(const MapComparison& comparison, const std::vector<GhostWall>& ghosts,
                          double tolerance_m);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_WALL_ERRORS_H_
