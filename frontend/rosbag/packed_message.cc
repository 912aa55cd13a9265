// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/packed_message.h"

#include <algorithm>
#include <optional>

#include "frontend/rosbag/byte_cursor.h"
#include "frontend/rosbag/unpack.h"
#include "frontend/sensor/record_fields.h"

namespace gmapping_spa::rosbag {

using sensor::MalformedRecord;

std::string UnpackMessage(const BagMessage& message, std::uint64_t most) {
  const std::optional<std::uint64_t> size = ZstdSize(message.data);
  if (!size || *size > most) {
    throw MalformedRecord("expected a message packed by zstd that tells its size, up to " +
                          std::to_string(std::min(kMaxChunkBytes, most)) + " bytes");
  }
  try {
    return Unpack(Packing::kZstd, message.data, *size, *message.file, message.place);
  } catch (const BagError&) {
    throw MalformedRecord("expected a message packed by zstd, found a damaged one");
  }
}

}  // namespace gmapping_spa::rosbag
