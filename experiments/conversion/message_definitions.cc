// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/conversion/message_definitions.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace gmapping_spa::conversion {
namespace {

struct Definition {
  std::string_view type;
  std::string_view fields;
  std::vector<std::string_view> within;  // types of the fields, and of theirs
};

const std::vector<Definition>& Definitions() {
  static const std::vector<Definition> kDefinitions = {
      {"sensor_msgs/LaserScan",
       "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
       "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
       "float32[] ranges\nfloat32[] intensities\n",
       {"std_msgs/Header"}},
      {"nav_msgs/Odometry",
       "std_msgs/Header header\nstring child_frame_id\n"
       "geometry_msgs/PoseWithCovariance pose\ngeometry_msgs/TwistWithCovariance twist\n",
       {"std_msgs/Header", "geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose",
        "geometry_msgs/Point", "geometry_msgs/Quaternion", "geometry_msgs/TwistWithCovariance",
        "geometry_msgs/Twist", "geometry_msgs/Vector3"}},
      {"tf2_msgs/TFMessage",
       "geometry_msgs/TransformStamped[] transforms\n",
       {"geometry_msgs/TransformStamped", "std_msgs/Header", "geometry_msgs/Transform",
        "geometry_msgs/Vector3", "geometry_msgs/Quaternion"}},
      {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n", {}},
      {"geometry_msgs/TwistWithCovariance",
       "geometry_msgs/Twist twist\nfloat64[36] covariance\n",
       {}},
      {"geometry_msgs/Pose",
       "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n",
       {}},
      {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n", {}},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n", {}},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n", {}},
      {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n", {}},
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n",
       {}},
      {"geometry_msgs/Transform",
       "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n",
       {}}};
  return kDefinitions;
}

std::string FieldsOf(std::string_view type, bool is_ros1) {
  if (type == "std_msgs/Header") {
    return is_ros1 ? "uint32 seq\ntime stamp\nstring frame_id\n"
                   : "builtin_interfaces/Time stamp\nstring frame_id\n";
  }
  if (type == "builtin_interfaces/Time") return "int32 sec\nuint32 nanosec\n";
  const auto found = std::ranges::find(Definitions(), type, &Definition::type);
  if (found == Definitions().end()) throw std::invalid_argument("a type without a definition");
  return std::string(found->fields);
}

}  // namespace

std::string DefinitionOf(std::string_view type, rosbag::Encoding encoding) {
  const bool is_ros1 = encoding == rosbag::Encoding::kRos1;
  std::string text = FieldsOf(type, is_ros1);
  std::vector<std::string_view> within =
      std::ranges::find(Definitions(), type, &Definition::type)->within;
  if (!is_ros1) within.push_back("builtin_interfaces/Time");
  for (const std::string_view other : within) {
    text += std::string(80, '=') + "\nMSG: ";
    text += other;
    text += "\n";
    text += FieldsOf(other, is_ros1);
  }
  return text;
}

std::string Ros2TypeName(std::string_view type) {
  std::string name(type);
  return name.replace(name.find('/'), 1, "/msg/");
}

}  // namespace gmapping_spa::conversion
