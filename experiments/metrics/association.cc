// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/association.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gmapping_spa::metrics {
namespace {

using backend::SE2;
using backend::StampedPose;
using backend::Trajectory;

// The first pose whose stamp is not before `stamp_s`.
Trajectory::const_iterator FirstNotBefore(const Trajectory& trajectory, double stamp_s) {
  return std::lower_bound(
      trajectory.begin(), trajectory.end(), stamp_s,
      [](const StampedPose& pose, double stamp) { return pose.stamp_s < stamp; });
}

// The pose nearest in time, if it is near enough: the first one of equal stamps, the earlier of two
// as near.
const StampedPose* Nearest(const Trajectory& trajectory, double stamp_s, double max_gap_s) {
  auto nearest = FirstNotBefore(trajectory, stamp_s);
  if (nearest != trajectory.begin()) {
    const auto before = FirstNotBefore(trajectory, std::prev(nearest)->stamp_s);
    if (nearest == trajectory.end() || stamp_s - before->stamp_s <= nearest->stamp_s - stamp_s) {
      nearest = before;
    }
  }
  if (nearest == trajectory.end() || std::abs(nearest->stamp_s - stamp_s) > max_gap_s) {
    return nullptr;
  }
  return &*nearest;
}

}  // namespace

Trajectory SortedByStamp(Trajectory trajectory) {
  std::stable_sort(
      trajectory.begin(), trajectory.end(),
      [](const StampedPose& a, const StampedPose& b) { return a.stamp_s < b.stamp_s; });
  return trajectory;
}

std::optional<SE2> PoseAt(const Trajectory& trajectory, double stamp_s, double max_gap_s) {
  const StampedPose* nearest = Nearest(trajectory, stamp_s, max_gap_s);
  if (nearest == nullptr) return std::nullopt;
  const auto after = FirstNotBefore(trajectory, stamp_s);
  if (nearest->stamp_s == stamp_s || after == trajectory.begin() || after == trajectory.end()) {
    return nearest->world_T_robot;
  }
  const auto before = std::prev(after);
  const double fraction = (stamp_s - before->stamp_s) / (after->stamp_s - before->stamp_s);
  const SE2 before_T_after = backend::Between(before->world_T_robot, after->world_T_robot);
  return before->world_T_robot * backend::Exp(fraction * backend::Log(before_T_after));
}

std::vector<PosePair> AssociateByStamp(const Trajectory& truth, const Trajectory& estimate,
                                       double max_gap_s) {
  const Trajectory sorted_truth = SortedByStamp(truth);
  const Trajectory sorted_estimate = SortedByStamp(estimate);
  std::vector<PosePair> pairs;
  if (estimate.size() <= truth.size()) {
    for (const auto& [stamp_s, estimate_T_robot] : sorted_estimate) {
      if (const StampedPose* match = Nearest(sorted_truth, stamp_s, max_gap_s)) {
        pairs.push_back({stamp_s, match->world_T_robot, estimate_T_robot});
      }
    }
  } else {
    for (const auto& [stamp_s, truth_T_robot] : sorted_truth) {
      if (const StampedPose* match = Nearest(sorted_estimate, stamp_s, max_gap_s)) {
        pairs.push_back({match->stamp_s, truth_T_robot, match->world_T_robot});
      }
    }
  }
  return pairs;
}

}  // namespace gmapping_spa::metrics
