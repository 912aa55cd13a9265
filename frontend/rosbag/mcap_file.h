// SPDX-License-Identifier: BSD-3-Clause
// MCAP, the container of ROS 2 bags since Iron and of others (https://mcap.dev/spec).
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_MCAP_FILE_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_MCAP_FILE_H_

#include <memory>
#include <string_view>

#include "frontend/rosbag/byte_file.h"
#include "frontend/rosbag/message_source.h"

namespace gmapping_spa::rosbag {

inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

// Chunks may be packed by lz4 or zstd; messages may lie outside of chunks. Where the summary at the
// end does not tell all chunks and topics, or is not there since the file was never closed, the
// file is read through at once. Throws BagError where the file is not as the format has it.
std::unique_ptr<MessageSource> OpenMcap(const ByteFile& file);

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_MCAP_FILE_H_
