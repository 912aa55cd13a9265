// SPDX-License-Identifier: BSD-3-Clause
// The direction in which a scan says least about where the robot is: that of a corridor.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_WEAKEST_DIRECTION_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_WEAKEST_DIRECTION_H_

#include <Eigen/Core>

namespace gmapping_spa::scan_matching {

struct WeakestDirection {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  // of length 1
  double information = 0.0;                              // along it, per m^2
};

// Of the inverse covariance of (x, y, theta), whatever the heading is.
WeakestDirection FindWeakestDirection(const Eigen::Matrix3d& information);

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_WEAKEST_DIRECTION_H_
