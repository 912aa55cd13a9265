// SPDX-License-Identifier: BSD-3-Clause
// Scan matching by Gauss-Newton: the scan is aligned, and the result judged by how well it fits.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_MATCHER_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_MATCHER_H_

#include "frontend/scan_matching/endpoint_model.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "frontend/scan_matching/scan_matcher.h"

namespace gmapping_spa::scan_matching {

class GaussNewtonMatcher : public ScanMatcher {
 public:
  struct Options {
    GaussNewton::Options alignment;
    double min_score = 0.2;  // a match below this is a failure
  };

  GaussNewtonMatcher(const Options& options, const EndpointModel::Options& model_options);

  // The minimum where it fits at least as well as the initial pose, else that.
  MatchResult Match(const map::OccupancyGrid& grid, const ScanPoints& points,
                    const backend::SE2& initial_world_T_robot,
                    const Eigen::Matrix3d& prior_information) const override;

 private:
  GaussNewton gauss_newton_;
  EndpointModel::Options model_options_;
  double min_score_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_GAUSS_NEWTON_MATCHER_H_
