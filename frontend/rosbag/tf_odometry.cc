// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/tf_odometry.h"

namespace gmapping_spa::rosbag {

TfOdometry::TfOdometry(const std::string& odom_frame) : odom_frame_(odom_frame) {
  if (odom_frame_.starts_with('/')) odom_frame_.erase(0, 1);
}

bool TfOdometry::Is(const TransformMessage& transform) {
  const std::string& parent = transform.header.frame_id;
  const std::string& child = transform.child_frame_id;
  if (child_.empty()) {
    const bool is_odom =
        odom_frame_.empty() ? parent.find("odom") != std::string::npos : parent == odom_frame_;
    // Some localizations tell the map below the odometry.
    if (!is_odom || child == "map" || child.ends_with("/map")) return false;
    parent_ = parent;
    child_ = child;
  }
  return parent == parent_ && child == child_;
}

std::string TfOdometry::name() const { return child_.empty() ? "" : parent_ + " -> " + child_; }

}  // namespace gmapping_spa::rosbag
