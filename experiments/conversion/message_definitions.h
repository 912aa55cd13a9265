// SPDX-License-Identifier: BSD-3-Clause
// The definitions of the messages that are written, so that other tools can read them.
#ifndef GMAPPING_SPA_EXPERIMENTS_CONVERSION_MESSAGE_DEFINITIONS_H_
#define GMAPPING_SPA_EXPERIMENTS_CONVERSION_MESSAGE_DEFINITIONS_H_

#include <string>
#include <string_view>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::conversion {

// Of sensor_msgs/LaserScan, nav_msgs/Odometry and tf2_msgs/TFMessage: with those of all types
// within it, as bags hold it (each behind a line "MSG: <type>").
std::string DefinitionOf(std::string_view type, rosbag::Encoding encoding);

// "sensor_msgs/msg/LaserScan"
std::string Ros2TypeName(std::string_view type);

}  // namespace gmapping_spa::conversion

#endif  // GMAPPING_SPA_EXPERIMENTS_CONVERSION_MESSAGE_DEFINITIONS_H_
