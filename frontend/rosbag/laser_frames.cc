// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/laser_frames.h"

#include <algorithm>
#include <cmath>

#include "frontend/rosbag/ros_messages.h"

namespace gmapping_spa::rosbag {
namespace {

std::optional<Mounting> MountingOn(const TransformTree& tree, const std::string& base_frame,
                                   const std::string& frame) {
  const std::optional<Eigen::Isometry3d> base_T_frame = tree.Lookup(base_frame, frame);
  if (!base_T_frame) return std::nullopt;
  const double upward = base_T_frame->linear()(2, 2);
  return Mounting{InPlane(*base_T_frame), upward < 0.0, std::acos(std::min(std::abs(upward), 1.0)),
                  base_frame};
}

}  // namespace

LaserFrames::LaserFrames(const std::string& base_frame) : base_frame_(base_frame) {
  if (base_frame_.starts_with('/')) base_frame_.erase(0, 1);
}

void LaserFrames::SetOdometryFrame(const std::string& frame) {
  if (base_frame_.empty()) base_frame_ = frame;
}

std::optional<Mounting> LaserFrames::Find(const TransformTree& tree,
                                          const std::string& frame) const {
  if (base_frame_.empty()) return std::nullopt;
  return MountingOn(tree, base_frame_, frame);
}

Mounting LaserFrames::FindOrAssume(const TransformTree& tree, const std::string& frame) const {
  if (const std::optional<Mounting> found = Find(tree, frame)) return *found;
  for (const char* usual : {"base_link", "base_footprint"}) {
    // A frame is connected with itself, which says nothing of the robot's.
    if (frame == usual) continue;
    if (const std::optional<Mounting> found = MountingOn(tree, usual, frame)) return *found;
  }
  return {};
}

}  // namespace gmapping_spa::rosbag
