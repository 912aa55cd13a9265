// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/ros_messages.h"

#include <cmath>
#include <limits>

#include "backend/graph/planar_quaternion.h"
#include "frontend/rosbag/message_fields.h"
#include "frontend/sensor/record_fields.h"

namespace gmapping_spa::rosbag {
namespace {

using sensor::MalformedRecord;

struct KnownType {
  std::string_view name;
  MessageType type;
  std::string_view md5sum;
};

constexpr KnownType kTypes[] = {
    {"sensor_msgs/LaserScan", MessageType::kLaserScan, "90c7ef2dc6895d81024acba2ac42f369"},
    {"sensor_msgs/MultiEchoLaserScan", MessageType::kMultiEchoLaserScan,
     "6fefb0c6da89d7c8abe4b339f5c2f8fb"},
    {"nav_msgs/Odometry", MessageType::kOdometry, "cd5e73d190d741a2f92e81eda573aca7"},
    {"tf2_msgs/TFMessage", MessageType::kTf, "94810edda583a504dfda3829e70d7eec"},
    {"tf/tfMessage", MessageType::kTf, "94810edda583a504dfda3829e70d7eec"},
};

// Farther off, later arithmetic would lose all digits.
constexpr double kFarthest_m = 1e9;

std::string FrameId(MessageFields& fields, const char* what) {
  std::string frame = fields.Text(what);
  if (frame.starts_with('/')) frame.erase(0, 1);
  return frame;
}

MessageHeader ReadHeader(MessageFields& fields) {
  MessageHeader header;
  if (fields.is_ros1()) fields.Take<std::uint32_t>("a sequence number");
  // ROS 2 counts seconds with a sign.
  const auto word = fields.Take<std::uint32_t>("a stamp");
  const std::int64_t seconds =
      fields.is_ros1() ? std::int64_t{word} : std::int64_t{static_cast<std::int32_t>(word)};
  header.stamp_ns = 1000000000 * seconds + fields.Take<std::uint32_t>("a stamp");
  header.frame_id = FrameId(fields, "a frame");
  return header;
}

double Finite(double value, double limit, const char* what) {
  if (std::abs(value) <= limit) return value;
  throw MalformedRecord(std::string("expected ") + what + " of sane size, found " +
                        std::to_string(value));
}

struct Pose {
  Eigen::Vector3d translation;
  Eigen::Quaterniond rotation;
};

// A translation or position, and a quaternion x y z w.
Pose TakePose(MessageFields& fields) {
  Eigen::Vector3d translation;
  for (double& value : translation) {
    value = Finite(fields.Take<double>("a position"), kFarthest_m, "a position");
  }
  Eigen::Quaterniond rotation;
  for (double& value : rotation.coeffs()) {
    value = Finite(fields.Take<double>("a quaternion"), 1e3, "a quaternion");
  }
  if (std::abs(rotation.norm() - 1.0) > 0.1) {
    throw MalformedRecord("expected a quaternion of length 1, found one of " +
                          std::to_string(rotation.norm()));
  }
  return {translation, rotation};
}

}  // namespace

MessageType TypeNamed(std::string_view type) {
  for (const KnownType& known : kTypes) {
    if (known.name == type) return known.type;
  }
  return MessageType::kOther;
}

std::string_view Md5SumOf(MessageType type) {
  for (const KnownType& known : kTypes) {
    if (known.type == type) return known.md5sum;
  }
  return {};
}

LaserScanMessage ParseLaserScan(std::string_view data, Encoding encoding, MessageType type) {
  MessageFields fields(data, encoding);
  LaserScanMessage scan;
  scan.header = ReadHeader(fields);
  constexpr double kMostRad = 1e3;
  scan.angle_min_rad = Finite(fields.Take<float>("an angle"), kMostRad, "an angle");
  scan.angle_max_rad = Finite(fields.Take<float>("an angle"), kMostRad, "an angle");
  scan.angle_increment_rad = Finite(fields.Take<float>("an angle"), kMostRad, "an angle");
  scan.time_increment_s = fields.Take<float>("a time");
  fields.Take<float>("a time");  // of the scan, often left at zero
  scan.range_min_m = fields.Take<float>("a range");
  scan.range_max_m = fields.Take<float>("a range");
  if (type == MessageType::kLaserScan) {
    scan.ranges_m = fields.Floats("ranges");
    return scan;
  }
  const std::size_t count = fields.Count(sizeof(std::uint32_t), "echoes");
  scan.ranges_m.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> echoes_m = fields.Floats("ranges");
    scan.ranges_m.push_back(echoes_m.empty() ? std::numeric_limits<double>::quiet_NaN()
                                             : echoes_m.front());
  }
  return scan;
}

OdometryMessage ParseOdometry(std::string_view data, Encoding encoding) {
  MessageFields fields(data, encoding);
  OdometryMessage odometry;
  odometry.header = ReadHeader(fields);
  odometry.child_frame_id = FrameId(fields, "a frame");
  const auto [position, q] = TakePose(fields);
  // Not by a matrix, which would round: what a converter writes is to be read back exactly.
  odometry.odom_T_child = {position.x(), position.y(), backend::YawOf(q.x(), q.y(), q.z(), q.w())};
  return odometry;
}

std::vector<TransformMessage> ParseTf(std::string_view data, Encoding encoding) {
  MessageFields fields(data, encoding);
  constexpr std::size_t kLeastBytes = 8 + 4 + 4 + 56;  // stamp, two names, transform
  std::vector<TransformMessage> transforms(fields.Count(kLeastBytes, "transforms"));
  for (TransformMessage& transform : transforms) {
    transform.header = ReadHeader(fields);
    transform.child_frame_id = FrameId(fields, "a frame");
    const auto [translation, rotation] = TakePose(fields);
    transform.parent_T_child = Eigen::Translation3d(translation) * rotation.normalized();
  }
  return transforms;
}

backend::SE2 InPlane(const Eigen::Isometry3d& a_T_b) {
  const Eigen::Vector3d x_axis = a_T_b.linear().col(0);
  return {a_T_b.translation().x(), a_T_b.translation().y(), std::atan2(x_axis.y(), x_axis.x())};
}

}  // namespace gmapping_spa::rosbag
