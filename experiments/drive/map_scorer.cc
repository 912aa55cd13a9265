// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/map_scorer.h"

#include <algorithm>
#include <vector>

#include "experiments/metrics/association.h"
#include "experiments/metrics/map_comparison.h"
#include "experiments/metrics/map_error.h"
#include "experiments/metrics/trajectory_error.h"
#include "frontend/map/map_building.h"

namespace gmapping_spa::drive {
namespace {

// The defaults of evaluate_map.
constexpr double kMaxGapS = 0.01;
constexpr double kToleranceM = 0.1;
// Before, the positions do not tell how the frames lie to each other.
constexpr double kShortestM = 1.0;

double ExtentM(const std::vector<metrics::PosePair>& pairs) {
  double extent_m = 0.0;
  for (const metrics::PosePair& pair : pairs) {
    const Eigen::Vector2d way =
        pair.truth_T_robot.translation() - pairs.front().truth_T_robot.translation();
    extent_m = std::max(extent_m, way.norm());
  }
  return extent_m;
}

}  // namespace

MapScore MapScorer::Score(const backend::Trajectory& trajectory, const map::OccupancyGrid& grid,
                          double occupied_threshold) {
  const std::size_t steps = tour_->steps();
  const backend::Trajectory news = tour_->TrueTrajectory(steps_, steps);
  true_poses_.insert(true_poses_.end(), news.begin(), news.end());
  steps_ = steps;
  MapScore score;
  score.stamp_s = trajectory.back().stamp_s;
  const std::vector<metrics::PosePair> pairs =
      metrics::AssociateByStamp(true_poses_, trajectory, kMaxGapS);
  if (pairs.empty() || ExtentM(pairs) < kShortestM) return score;
  score.ate_m =
      metrics::AbsoluteTrajectoryError(pairs, metrics::Alignment::kSe2).translation_m.rmse;
  while (looked_ < true_poses_.size() && true_poses_[looked_].stamp_s <= score.stamp_s) {
    lookout_.Look(true_poses_[looked_++].world_T_robot);
  }
  const map::TrinaryMap map = map::BuildTrinaryMap(grid, occupied_threshold);
  if (lookout_.seen().view_points == 0 || map.cells.empty()) return score;
  const backend::SE2 truth_T_map = metrics::Align(pairs, metrics::Alignment::kSe2);
  const auto comparison = metrics::CompareMaps(*truth_, lookout_.seen(), map, truth_T_map);
  score.iou = metrics::SummarizeErrors(comparison, kToleranceM).iou;
  return score;
}

}  // namespace gmapping_spa::drive
