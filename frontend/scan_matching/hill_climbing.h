// SPDX-License-Identifier: BSD-3-Clause
// The scan matcher of GMapping: greedy moves on the map, in ever smaller steps.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_HILL_CLIMBING_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_HILL_CLIMBING_H_

#include "frontend/scan_matching/endpoint_model.h"
#include "frontend/scan_matching/scan_matcher.h"

namespace gmapping_spa::scan_matching {

class HillClimbing : public ScanMatcher {
 public:
  struct Options {
    double linear_step_m = 0.05;     // first step
    double angular_step_rad = 0.05;  // first step
    int num_refinements = 5;         // how often the steps are halved before it stops
    double min_score = 0.2;          // a match below this is a failure
  };

  HillClimbing(const Options& options, const EndpointModel::Options& model_options);

  MatchResult Match(const map::OccupancyGrid& grid, const ScanPoints& points,
                    const backend::SE2& initial_world_T_robot,
                    const Eigen::Matrix3d& prior_information) const override;

 private:
  Options options_;
  EndpointModel::Options model_options_;
};

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_HILL_CLIMBING_H_
