// SPDX-License-Identifier: BSD-3-Clause
// Which of the transforms of a bag is the odometry.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_TF_ODOMETRY_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_TF_ODOMETRY_H_

#include <string>

#include "frontend/rosbag/ros_messages.h"

namespace gmapping_spa::rosbag {

// The transform from the odometry's frame to the robot: the first one of a frame named odom, or
// with odom in its name, and from then on that one alone.
class TfOdometry {
 public:
  // `odom_frame`: its name, where it is known.
  explicit TfOdometry(const std::string& odom_frame);

  bool Is(const TransformMessage& transform);

  // "odom -> base_link"; empty where there was none yet.
  std::string name() const;

 private:
  std::string odom_frame_;
  std::string parent_, child_;  // of the transform
};

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_TF_ODOMETRY_H_
