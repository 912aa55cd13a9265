// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/mcap_records.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace gmapping_spa::rosbag {
namespace {

// Schemas and channels, which come before the messages that use them.
class Declarations {
 public:
  void AddSchema(ByteCursor record) {
    const auto id = record.Take<std::uint16_t>("a schema's id");
    schemas_[id] = Ros1TypeName(record.Prefixed("a schema's name"));
  }

  void AddChannel(ByteCursor record, ChunkVisitor* visitor) {
    const auto id = record.Take<std::uint16_t>("a channel's id");
    const auto schema = record.Take<std::uint16_t>("a schema's id");
    BagTopic topic;
    topic.name = std::string(record.Prefixed("a topic's name"));
    const std::string_view encoding = record.Prefixed("an encoding");
    topic.encoding = encoding == "ros1"  ? Encoding::kRos1
                     : encoding == "cdr" ? Encoding::kCdr
                                         : Encoding::kUnknown;
    if (schema != 0) {
      const auto found = schemas_.find(schema);
      if (found == schemas_.end()) {
        record.Fail("expected a channel of a schema before it, found the schema " +
                    std::to_string(schema));
      }
      topic.type = found->second;
    }
    for (ByteCursor metadata = record.PrefixedCursor("metadata"); !metadata.empty();) {
      const std::string_view key = metadata.Prefixed("a key");
      const std::string_view value = metadata.Prefixed("a value");
      if (topic.encoding == Encoding::kRos1 && key == "md5sum") topic.md5sum = value;
    }
    visitor->OnTopic(id, std::move(topic), record);
  }

 private:
  std::map<std::uint16_t, std::string> schemas_;
};

// Calls visit(opcode, record) for each record.
template <typename Visit>
void ForEachRecord(ByteCursor records, Visit visit) {
  while (!records.empty()) {
    const auto opcode = static_cast<McapOpcode>(records.Take<std::uint8_t>("an opcode"));
    const auto length = records.Take<std::uint64_t>("a record's length");
    visit(opcode, records.Part(length, "a record"));
  }
}

void ParseMessage(ByteCursor record, ChunkVisitor* visitor) {
  const auto channel = record.Take<std::uint16_t>("a channel's id");
  record.Take<std::uint32_t>("a sequence number");
  const auto log_time = record.Take<std::uint64_t>("a time");
  record.Take<std::uint64_t>("a time");  // of publication
  visitor->OnMessage(channel, static_cast<std::int64_t>(log_time),
                     record.Bytes(record.size(), "a message"), record);
}

}  // namespace

void ParseMcapMessages(ByteCursor records, ChunkVisitor* visitor) {
  ForEachRecord(records, [visitor](McapOpcode opcode, const ByteCursor& record) {
    if (opcode == McapOpcode::kMessage) ParseMessage(record, visitor);
  });
}

ChunkParser MakeMcapParser() {
  auto declarations = std::make_shared<Declarations>();
  return [declarations](const ByteCursor& records, ChunkVisitor* visitor) {
    ForEachRecord(records, [&](McapOpcode opcode, const ByteCursor& record) {
      if (opcode == McapOpcode::kSchema) declarations->AddSchema(record);
      if (opcode == McapOpcode::kChannel) declarations->AddChannel(record, visitor);
      if (opcode == McapOpcode::kMessage) ParseMessage(record, visitor);
    });
  };
}

std::optional<McapRecord> ReadMcapRecord(const ByteFile& file, std::int64_t byte) {
  const std::string bytes = file.ReadUpTo(byte, McapRecord::kHeaderBytes);
  if (bytes.size() < static_cast<std::size_t>(McapRecord::kHeaderBytes)) return std::nullopt;
  ByteCursor cursor(bytes, file.path(), byte);
  McapRecord record{byte, static_cast<McapOpcode>(cursor.Take<std::uint8_t>("an opcode")), 0};
  record.bytes = cursor.Take<std::uint64_t>("a length");
  if (record.bytes > static_cast<std::uint64_t>(file.size() - record.data_byte())) {
    return std::nullopt;
  }
  return record;
}

// Its data follows what is read of it.
Chunk McapChunk(const ByteFile& file, const McapRecord& record) {
  constexpr std::int64_t kMostBytes = 256;  // of the fields in front
  const std::string bytes = file.ReadUpTo(
      record.data_byte(), std::min(kMostBytes, static_cast<std::int64_t>(record.bytes)));
  ByteCursor fields(bytes, file.path(), record.data_byte());
  Chunk chunk;
  chunk.byte = record.byte;
  chunk.first_ns = static_cast<std::int64_t>(fields.Take<std::uint64_t>("a time"));
  chunk.last_ns = static_cast<std::int64_t>(fields.Take<std::uint64_t>("a time"));
  chunk.bytes = fields.Take<std::uint64_t>("a size");
  chunk.crc = fields.Take<std::uint32_t>("a CRC");
  const std::string_view compression = fields.Prefixed("a compression");
  const std::optional<Packing> packing = PackingNamed(compression);
  if (!packing || *packing == Packing::kBz2) {
    fields.Fail("expected a chunk packed by none, lz4 or zstd, found another compression");
  }
  chunk.packing = *packing;
  chunk.packed_bytes = fields.Take<std::uint64_t>("a size");
  chunk.data_byte = record.data_byte() + static_cast<std::int64_t>(bytes.size() - fields.size());
  if (chunk.packed_bytes != static_cast<std::uint64_t>(record.end() - chunk.data_byte)) {
    fields.Fail("expected a chunk of " + std::to_string(record.end() - chunk.data_byte) +
                " bytes, as its record has room for, found one that says it has " +
                std::to_string(chunk.packed_bytes));
  }
  return chunk;
}

}  // namespace gmapping_spa::rosbag
