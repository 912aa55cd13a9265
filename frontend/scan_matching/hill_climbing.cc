// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/hill_climbing.h"

#include <glog/logging.h>

namespace gmapping_spa::scan_matching {

using backend::SE2;

HillClimbing::HillClimbing(const Options& options, const EndpointModel::Options& model_options)
    : options_(options), model_options_(model_options) {
  CHECK_GT(options.linear_step_m, 0.0);
  CHECK_GT(options.angular_step_rad, 0.0);
  CHECK_GE(options.num_refinements, 0);
}

MatchResult HillClimbing::Match(const map::OccupancyGrid& grid, const ScanPoints& points,
                                const SE2& initial_world_T_robot,
                                const Eigen::Matrix3d& /*prior_information*/) const {
  EndpointModel model(model_options_, &grid, &points);
  SE2 best = initial_world_T_robot;
  double best_score = model.Score(best);
  double linear = options_.linear_step_m, angular = options_.angular_step_rad;
  for (int halving = 0; halving <= options_.num_refinements; ++halving) {
    for (bool moved = true; moved;) {
      moved = false;
      // Moves in the robot frame, all tried from the same pose; the best one is taken.
      const SE2 from = best;
      for (const SE2& move : {SE2{linear, 0, 0}, SE2{-linear, 0, 0}, SE2{0, linear, 0},
                              SE2{0, -linear, 0}, SE2{0, 0, angular}, SE2{0, 0, -angular}}) {
        const SE2 candidate = from * move;
        const double score = model.Score(candidate, best_score);
        if (score > best_score) {
          best = candidate;
          best_score = score;
          moved = true;
        }
      }
    }
    linear /= 2;
    angular /= 2;
  }
  return {best_score >= options_.min_score && !points.empty(), best, best_score};
}

}  // namespace gmapping_spa::scan_matching
