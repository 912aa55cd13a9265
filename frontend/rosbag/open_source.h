// SPDX-License-Identifier: BSD-3-Clause
// Opens whatever kind of bag there is.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_OPEN_SOURCE_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_OPEN_SOURCE_H_

#include <memory>
#include <string>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::rosbag {

// A ROS 1 bag, MCAP or db3, by the first bytes of the file; or a folder: the files that its
// metadata.yaml lists, else all bags in it. These follow each other in the order of time, one is
// open at a time. Throws std::runtime_error with one line.
std::unique_ptr<MessageSource> OpenSource(const std::string& path);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_OPEN_SOURCE_H_
