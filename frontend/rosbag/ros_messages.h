// SPDX-License-Identifier: BSD-3-Clause
// The messages of ROS that are read: what SLAM needs of them.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_ROS_MESSAGES_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_ROS_MESSAGES_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "backend/se2.h"
#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::rosbag {

enum class MessageType : std::uint8_t { kOther, kLaserScan, kMultiEchoLaserScan, kOdometry, kTf };

// By its name in the way of ROS 1. tf/tfMessage is the former name of tf2_msgs/TFMessage.
MessageType TypeNamed(std::string_view type);
// The MD5 sum by which ROS 1 tells definitions apart.
std::string_view Md5SumOf(MessageType type);

struct MessageHeader {
  std::int64_t stamp_ns = 0;
  std::string frame_id;  // without the slash that old ones have in front
};

// sensor_msgs/LaserScan, or the first echo of sensor_msgs/MultiEchoLaserScan (nan without any).
struct LaserScanMessage {
  MessageHeader header;  // the stamp is the time of the first beam
  double angle_min_rad = 0.0, angle_max_rad = 0.0, angle_increment_rad = 0.0;
  double time_increment_s = 0.0;  // from beam to beam
  double range_min_m = 0.0, range_max_m = 0.0;
  std::vector<double> ranges_m;
};

// nav_msgs/Odometry
struct OdometryMessage {
  MessageHeader header;
  std::string child_frame_id;
  backend::SE2 odom_T_child;
};

// geometry_msgs/TransformStamped
struct TransformMessage {
  MessageHeader header;
  std::string child_frame_id;
  Eigen::Isometry3d parent_T_child = Eigen::Isometry3d::Identity();
};

// Throw sensor::MalformedRecord where the message is too short, a number that must be finite is
// not, or a quaternion is none.
LaserScanMessage ParseLaserScan(std::string_view data, Encoding encoding, MessageType type);
OdometryMessage ParseOdometry(std::string_view data, Encoding encoding);
std::vector<TransformMessage> ParseTf(std::string_view data, Encoding encoding);

// The motion in the plane that a motion in space is, seen from above: the heading is that of the
// x axis.
backend::SE2 InPlane(const Eigen::Isometry3d& a_T_b);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_ROS_MESSAGES_H_
