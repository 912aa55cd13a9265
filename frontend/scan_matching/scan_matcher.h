// SPDX-License-Identifier: BSD-3-Clause
// Aligning a scan with a map.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCAN_MATCHER_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCAN_MATCHER_H_

#include <Eigen/Core>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

struct MatchResult {
  bool success = false;        // whether the pose can be trusted
  backend::SE2 world_T_robot;  // the best pose found, trusted or not
  double score = 0.0;          // in [0, 1]: what the matcher maximizes, see EndpointModel
};

// Implementations keep no state, so that threads can share one.
class ScanMatcher {
 public:
  virtual ~ScanMatcher() = default;

  // Eq. (8): the pose near `initial_world_T_robot` at which the scan fits the map best.
  // `prior_information`: how sure the initial pose is about (x, y, theta) in the world frame.
  virtual MatchResult Match(const map::OccupancyGrid& grid, const ScanPoints& points,
                            const backend::SE2& initial_world_T_robot,
                            const Eigen::Matrix3d& prior_information) const = 0;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SCAN_MATCHER_H_
