// SPDX-License-Identifier: BSD-3-Clause
// Where lasers are mounted, as the transforms of a bag tell it.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_LASER_FRAMES_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_LASER_FRAMES_H_

#include <optional>
#include <string>

#include "backend/se2.h"
#include "frontend/rosbag/transform_tree.h"

namespace gmapping_spa::rosbag {

struct Mounting {
  backend::SE2 robot_T_frame;
  bool upside_down = false;  // the frame's z axis looks down
  double tilt_rad = 0.0;     // between the planes
  std::string base_frame;  // of the robot, with which tf connects it; empty: none, identity assumed
};

class LaserFrames {
 public:
  // `base_frame` is that of the robot; empty: that of the odometry.
  explicit LaserFrames(const std::string& base_frame);

  // The frame whose poses the odometry tells.
  void SetOdometryFrame(const std::string& frame);

  const std::string& base_frame() const { return base_frame_; }

  // How `frame` lies on the robot; nothing where tf does not connect them yet.
  std::optional<Mounting> Find(const TransformTree& tree, const std::string& frame) const;

  // Likewise when there is no more to wait for: base_link and base_footprint pass for the robot's
  // frame, and if these are not connected either, the frame is taken to be the robot's.
  Mounting FindOrAssume(const TransformTree& tree, const std::string& frame) const;

 private:
  std::string base_frame_;  // empty: not known
};

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_LASER_FRAMES_H_
