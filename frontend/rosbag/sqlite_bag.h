// SPDX-License-Identifier: BSD-3-Clause
// Bags of ROS 2 in SQLite databases (.db3), as rosbag2_storage_sqlite3 writes them.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_SQLITE_BAG_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_SQLITE_BAG_H_

#include <memory>
#include <string>
#include <string_view>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::rosbag {

inline constexpr std::string_view kSqliteMagic{"SQLite format 3\0", 16};

// Messages come in the order of their time stamps where the database has an index of these, as
// rosbag2 makes, else in the order in which they were written. Throws std::runtime_error with one
// line where the file is not as rosbag2 makes it.
std::unique_ptr<MessageSource> OpenSqliteBag(const std::string& path);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_SQLITE_BAG_H_
