// SPDX-License-Identifier: BSD-3-Clause
// How long the sweep of a scan took, from how it is bent.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SWEEP_FIT_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SWEEP_FIT_H_

#include <Eigen/Core>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

struct SweepFit {
  backend::SE2 world_T_robot;  // at the stamp of the scan
  double sweep_s = 0.0;        // from the first beam to the last one
  double information = 0.0;    // inverse variance of that, 1 / s^2, as if beams were independent
  double inliers = 0.0;        // sum of the robust weights, of at most the number of points
};

// Aligns a scan with a map by the pose and the duration of the sweep at once: Gauss-Newton on
// distances of points to surfaces, as in gauss_newton.h. `points`: not deskewed. `velocity`: of the
// robot, a twist in its frame (m/s, m/s, rad/s); a robot that stands still does not constrain it.
// Sees no farther than two cells: begin with several durations, and take the fit with the most
// inliers.
SweepFit FitSweep(const map::OccupancyGrid& grid, const ScanPoints& points,
                  const Eigen::Vector3d& velocity, const SweepFit& initial,
                  const GaussNewton::Options& options);

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_SWEEP_FIT_H_
