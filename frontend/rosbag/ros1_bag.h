// SPDX-License-Identifier: BSD-3-Clause
// Bags of ROS 1, format 2.0 (http://wiki.ros.org/Bags/Format/2.0).
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_ROS1_BAG_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_ROS1_BAG_H_

#include <memory>
#include <string_view>

#include "frontend/rosbag/byte_file.h"
#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::rosbag {

inline constexpr std::string_view kRos1Magic = "#ROSBAG V";

// Chunks may be packed by bz2 or lz4. A bag without an index, since its recorder was stopped before
// it closed the bag, is read through at once for what the index would tell; what is left at its end
// is counted. Throws BagError where the file is not as the format has it.
std::unique_ptr<MessageSource> OpenRos1Bag(const ByteFile& file);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_ROS1_BAG_H_
