// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/localization/views.h"

#include <cmath>

#include "frontend/scan_matching/joined_points.h"

namespace gmapping_spa::localization {

using backend::SE2;

bool Views::Add(const sensor::LaserScan& scan, const SE2& motion) {
  odom_T_robot_ = odom_T_robot_ * motion;
  way_m_ += motion.translation().norm();
  if (!views_.empty()) {
    const SE2 since = Between(views_.back().odom_T_robot, odom_T_robot_);
    if (since.translation().norm() < options_.every_m &&
        std::abs(since.theta) < options_.every_rad) {
      return false;
    }
  }
  views_.push_back({odom_T_robot_, way_m_, scan_matching::MakeEndPoints(scan)});
  while (way_m_ - views_.front().way_m > options_.reach_m ||
         static_cast<int>(views_.size()) > options_.max_views) {
    views_.pop_front();
  }
  return true;
}

scan_matching::ScanPoints Views::Joined(double cell_m) const {
  scan_matching::JoinedPoints joined(cell_m);
  for (const View& view : views_) {
    joined.Add(view.points, Between(odom_T_robot_, view.odom_T_robot));
  }
  return joined.points();
}

}  // namespace gmapping_spa::localization
