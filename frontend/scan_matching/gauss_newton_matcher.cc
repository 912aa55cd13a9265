// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/gauss_newton_matcher.h"

#include <algorithm>

namespace gmapping_spa::scan_matching {

using backend::SE2;

GaussNewtonMatcher::GaussNewtonMatcher(const Options& options,
                                       const EndpointModel::Options& model_options)
    : gauss_newton_(options.alignment),
      model_options_(model_options),
      min_score_(options.min_score) {}

MatchResult GaussNewtonMatcher::Match(const map::OccupancyGrid& grid, const ScanPoints& points,
                                      const SE2& initial_world_T_robot,
                                      const Eigen::Matrix3d& prior_information) const {
  const SE2 aligned =
      gauss_newton_.Align(grid, points, initial_world_T_robot, prior_information).world_T_robot;
  EndpointModel model(model_options_, &grid, &points);
  const double initial_fit = model.Evaluate(initial_world_T_robot).Fit();
  const double aligned_fit = model.Evaluate(aligned).Fit();
  const bool better = aligned_fit >= initial_fit;
  const double fit = std::max(aligned_fit, initial_fit);
  return {fit >= min_score_ && !points.empty(), better ? aligned : initial_world_T_robot, fit};
}

}  // namespace gmapping_spa::scan_matching
