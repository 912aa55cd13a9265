// SPDX-License-Identifier: BSD-3-Clause
// Bags of several files in a folder, as rosbag2 and `rosbag record --split` make them.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_BAG_FOLDER_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_BAG_FOLDER_H_

#include <memory>
#include <string>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::rosbag {

// Files that metadata.yaml lists and that are not there are counted. Throws std::runtime_error with
// one line where there is no file at all.
std::unique_ptr<MessageSource> OpenBagFolder(const std::string& folder);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_BAG_FOLDER_H_
