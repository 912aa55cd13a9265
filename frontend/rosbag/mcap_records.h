// SPDX-License-Identifier: BSD-3-Clause
// The records of MCAP that are needed to read messages (https://mcap.dev/spec).
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_MCAP_RECORDS_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_MCAP_RECORDS_H_

#include <cstdint>
#include <optional>

#include "frontend/rosbag/byte_file.h"
#include "frontend/rosbag/chunked_bag.h"

namespace gmapping_spa::rosbag {

enum class McapOpcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kDataEnd = 0x0F
};

// A record of the file itself; its data is not read yet.
struct McapRecord {
  static constexpr std::int64_t kHeaderBytes = 9;  // opcode, length

  std::int64_t byte = 0;
  McapOpcode opcode = McapOpcode::kHeader;
  std::uint64_t bytes = 0;  // of data

  std::int64_t data_byte() const { return byte + kHeaderBytes; }
  std::int64_t end() const { return data_byte() + static_cast<std::int64_t>(bytes); }
};

// Nothing where the file ends within the record.
std::optional<McapRecord> ReadMcapRecord(const ByteFile& file, std::int64_t byte);

// What the record of a chunk says of it.
Chunk McapChunk(const ByteFile& file, const McapRecord& record);

// Hands on the messages among the records of a chunk or of a part of the file.
void ParseMcapMessages(ByteCursor records, ChunkVisitor* visitor);

// Hands on the topics, too. Remembers schemas: they come before the channels that use them, in
// another chunk perhaps.
ChunkParser MakeMcapParser();

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_MCAP_RECORDS_H_
