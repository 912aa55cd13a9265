// SPDX-License-Identifier: BSD-3-Clause
// Messages that rosbag2 packed one by one.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_PACKED_MESSAGE_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_PACKED_MESSAGE_H_

#include <cstdint>
#include <string>

#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::rosbag {

// The bytes of a message packed by zstd. Throws MalformedRecord where it is damaged, or does not
// tell a size of at most `most` bytes.
std::string UnpackMessage(const BagMessage& message, std::uint64_t most);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_PACKED_MESSAGE_H_
