// SPDX-License-Identifier: BSD-3-Clause
// Aligning a scan with the surfaces of a map by Gauss-Newton: sub-cell, in a few iterations.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_H_

#include <Eigen/Core>
#include <cstdint>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

// Minimizes the robust sum over the beams of the squared Mahalanobis distance between end point and
// LocalSurface: the distance of generalized ICP (Segal et al. 2009) to a moving least squares
// surface (Levin 2004), by iteratively reweighted Gauss-Newton. The field of distances is never
// stored: it is summed up from the map's hit means where a beam ends, and so is always up to date.
class GaussNewton {
 public:
  struct Options {
    int max_iterations = 20;
    double noise_sigma_m = 0.02;  // of an end point, map errors included
    double robust_sigmas = 2.0;   // width of the Cauchy weight
    // Converged when no component of a step is larger, in m and in rad.
    double step_tolerance = 5e-4;
    friend bool operator==(const Options&, const Options&) = default;
  };

  struct Alignment {
    backend::SE2 world_T_robot;
    // Inverse covariance of (x, y, theta) in the world frame, as if all beams were independent.
    Eigen::Matrix3d world_information = Eigen::Matrix3d::Zero();
    double inliers = 0.0;  // sum of the robust weights, of at most the number of points
  };

  // How far normals of hit means are believed: what is no wall but looks like one may be the noise
  // of the ranges, or a rough wall. Usually poses take it for the latter.
  enum class Trust : std::uint8_t { kUsual, kLeast };

  explicit GaussNewton(const Options& options);

  // The minimum itself, however well it fits. `prior_information`: how sure the initial pose is
  // about (x, y, theta) in the world frame; positive definite, since a corridor does not constrain
  // the motion along it.
  Alignment Align(const map::OccupancyGrid& grid, const ScanPoints& points,
                  const backend::SE2& initial_world_T_robot,
                  const Eigen::Matrix3d& prior_information, Trust trust = Trust::kUsual) const;

  // A prior that decides nothing that any beam has a say in.
  static Eigen::Matrix3d WeakPrior() { return 1e-3 * Eigen::Matrix3d::Identity(); }

  // Alignment::world_information at a pose that is given.
  Eigen::Matrix3d InformationAt(const map::OccupancyGrid& grid, const ScanPoints& points,
                                const backend::SE2& world_T_robot) const;

  // Whether the scan surely tells the position in every direction, whatever its walls look like:
  // not in a corridor.
  bool TellsPosition(const map::OccupancyGrid& grid, const ScanPoints& points,
                     const backend::SE2& world_T_robot) const;

 private:
  Options options_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_H_
