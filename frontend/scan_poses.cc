// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_poses.h"

#include <glog/logging.h>

#include <algorithm>
#include <utility>

namespace gmapping_spa::frontend {

using backend::SE2;

void ScanPoses::Add(const sensor::LaserScan& scan, const SE2& odom_T_robot, double motion,
                    bool is_update) {
  CHECK(is_update || !entries_.empty());
  entries_.push_back({scan.index, scan.stamp_s, odom_T_robot, motion, is_update});
}

void ScanPoses::BeginPiece(int scans_back) {
  CHECK_LT(scans_back + 1, static_cast<int>(entries_.size()));
  const auto first = entries_.end() - 1 - scans_back;
  CHECK(std::none_of(first, entries_.end(), [](const Entry& entry) { return entry.is_update; }));
  first->is_update = true;
  first->begins_piece = true;
}

backend::Trajectory ScanPoses::Fill(const std::vector<SE2>& world_T_updates) const {
  std::vector<std::pair<std::int64_t, backend::StampedPose>> by_index;
  std::size_t update = 0;
  for (std::size_t begin = 0; begin < entries_.size(); ++update) {
    CHECK_LT(update, world_T_updates.size());
    std::size_t end = begin + 1;  // the next update, or the end of the log
    while (end < entries_.size() && !entries_[end].is_update) ++end;

    const SE2 world_T_odom = world_T_updates[update] * Inverse(entries_[begin].odom_T_robot);
    Eigen::Vector3d correction = Eigen::Vector3d::Zero();  // of the odometry's prediction
    double total_motion = 0.0;
    if (end < entries_.size() && !entries_[end].begins_piece) {
      const SE2 predicted = world_T_odom * entries_[end].odom_T_robot;
      correction = Minus(world_T_updates[update + 1], predicted);
      for (std::size_t k = begin + 1; k <= end; ++k) total_motion += entries_[k].motion;
    }
    double motion = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
      if (k > begin) motion += entries_[k].motion;
      const double share = total_motion > 0.0 ? motion / total_motion : 0.0;
      const SE2 predicted = world_T_odom * entries_[k].odom_T_robot;
      by_index.emplace_back(
          entries_[k].index,
          backend::StampedPose{entries_[k].stamp_s, Plus(predicted, share * correction)});
    }
    begin = end;
  }
  CHECK_EQ(update, world_T_updates.size());
  std::sort(by_index.begin(), by_index.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  backend::Trajectory trajectory;
  for (const auto& [index, pose] : by_index) trajectory.push_back(pose);
  return trajectory;
}

}  // namespace gmapping_spa::frontend
