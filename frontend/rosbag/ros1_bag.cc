// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/ros1_bag.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "frontend/rosbag/chunked_bag.h"

namespace gmapping_spa::rosbag {
namespace {

constexpr std::string_view kFirstLine = "#ROSBAG V2.0\n";
constexpr std::uint32_t kMaxHeaderBytes = 1 << 20;
constexpr std::uint32_t kMaxConnectionBytes = 16 << 20;  // of a message's definition

enum Operation : std::uint8_t {
  kMessage = 2,
  kBagHeader = 3,
  kIndexData = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7
};

// The named fields of a record's header: name=value, each behind its length.
class Header {
 public:
  explicit Header(ByteCursor fields) : fields_(fields) {}

  ByteCursor Field(std::string_view name) const {
    if (const std::optional<ByteCursor> value = TryField(name)) return *value;
    fields_.Fail("expected a record with the field '" + std::string(name) + "', found none");
  }
  std::optional<ByteCursor> TryField(std::string_view name) const {
    ByteCursor rest = fields_;
    while (!rest.empty()) {
      ByteCursor field = rest.PrefixedCursor("a field");
      ByteCursor seen = field;
      const std::string_view text = seen.Bytes(seen.size(), "a field");
      const std::size_t equals = text.find('=');
      if (equals == std::string_view::npos) field.Fail("expected name=value, found no '='");
      if (text.substr(0, equals) != name) continue;
      field.Bytes(equals + 1, "a name");
      return field;
    }
    return std::nullopt;
  }
  template <typename Number>
  Number Get(std::string_view name) const {
    return Field(name).Take<Number>("a number");
  }
  std::string Text(std::string_view name) const {
    ByteCursor value = Field(name);
    return std::string(value.Bytes(value.size(), "text"));
  }
  std::uint8_t operation() const { return Get<std::uint8_t>("op"); }
  std::int64_t Time(std::string_view name) const {
    ByteCursor value = Field(name);
    const auto seconds = value.Take<std::uint32_t>("a time");
    return std::int64_t{1000000000} * seconds + value.Take<std::uint32_t>("a time");
  }
  const ByteCursor& at() const { return fields_; }

 private:
  ByteCursor fields_;
};

// The header of a record says the topic, its data the type.
BagTopic TopicOf(const Header& header, ByteCursor data) {
  const Header connection(data);
  BagTopic topic;
  topic.name = header.Text("topic");
  topic.type = Ros1TypeName(connection.Text("type"));
  topic.encoding = Encoding::kRos1;
  topic.md5sum = connection.Text("md5sum");
  return topic;
}

void ParseChunk(ByteCursor records, ChunkVisitor* visitor) {
  while (!records.empty()) {
    const Header header(records.PrefixedCursor("a record's header"));
    ByteCursor data = records.PrefixedCursor("a record's data");
    const std::uint8_t operation = header.operation();
    if (operation == kConnection) {
      visitor->OnTopic(header.Get<std::uint32_t>("conn"), TopicOf(header, data), header.at());
    } else if (operation == kMessage) {
      visitor->OnMessage(header.Get<std::uint32_t>("conn"), header.Time("time"),
                         data.Bytes(data.size(), "a message"), header.at());
    }  // Others do not occur, and mean nothing here.
  }
}

// A record of the file itself; its data is not read yet.
struct FileRecord {
  std::int64_t byte = 0;
  std::string header_bytes;
  std::int64_t data_byte = 0;
  std::uint32_t data_bytes = 0;

  std::int64_t end() const { return data_byte + data_bytes; }
};

FileRecord ReadRecord(const ByteFile& file, std::int64_t byte) {
  FileRecord record;
  record.byte = byte;
  const auto length = [&](std::int64_t at) {
    const std::string bytes = file.Read(at, 4, "a record's length");
    return ByteCursor(bytes, file.path(), at).Take<std::uint32_t>("a length");
  };
  const std::uint32_t header_bytes = length(byte);
  if (header_bytes > kMaxHeaderBytes) {
    throw BagError(file.path(), byte,
                   "expected a record's header of at most " + std::to_string(kMaxHeaderBytes) +
                       " bytes, found one of " + std::to_string(header_bytes));
  }
  record.header_bytes = file.Read(byte + 4, header_bytes, "a record's header");
  record.data_byte = byte + 8 + header_bytes;
  record.data_bytes = length(byte + 4 + header_bytes);
  return record;
}

Header HeaderOf(const ByteFile& file, const FileRecord& record) {
  return Header(ByteCursor(record.header_bytes, file.path(), record.byte + 4));
}

std::string DataOf(const ByteFile& file, const FileRecord& record) {
  if (record.data_bytes > kMaxConnectionBytes) {
    throw BagError(file.path(), record.byte,
                   "expected a record of at most " + std::to_string(kMaxConnectionBytes) +
                       " bytes, found one of " + std::to_string(record.data_bytes));
  }
  return file.Read(record.data_byte, record.data_bytes, "a record's data");
}

Chunk ChunkOf(const ByteFile& file, const FileRecord& record) {
  const Header header = HeaderOf(file, record);
  if (header.operation() != kChunk) header.at().Fail("expected a chunk, found another record");
  const std::string compression = header.Text("compression");
  const std::optional<Packing> packing = PackingNamed(compression);
  if (!packing || *packing == Packing::kZstd) {
    header.at().Fail("expected a chunk packed by none, bz2 or lz4, found another compression");
  }
  Chunk chunk;
  chunk.byte = record.byte;
  chunk.data_byte = record.data_byte;
  chunk.packed_bytes = record.data_bytes;
  chunk.bytes = header.Get<std::uint32_t>("size");
  chunk.packing = *packing;
  return chunk;
}

void AddConnection(const ByteFile& file, const FileRecord& record, ChunkDirectory* directory) {
  const Header header = HeaderOf(file, record);
  const std::string data = DataOf(file, record);
  directory->AddTopic(header.Get<std::uint32_t>("conn"),
                      TopicOf(header, ByteCursor(data, file.path(), record.data_byte)),
                      header.at());
}

void AddIndexedChunk(const ByteFile& file, const FileRecord& info, ChunkDirectory* directory) {
  const Header header = HeaderOf(file, info);
  const auto byte = header.Get<std::uint64_t>("chunk_pos");
  if (byte > static_cast<std::uint64_t>(file.size())) {
    header.at().Fail("expected a chunk within the file, found its place at byte " +
                     std::to_string(byte));
  }
  Chunk chunk = ChunkOf(file, ReadRecord(file, static_cast<std::int64_t>(byte)));
  chunk.first_ns = header.Time("start_time");
  chunk.last_ns = header.Time("end_time");
  const std::string data = DataOf(file, info);
  for (ByteCursor counts(data, file.path(), info.data_byte); !counts.empty();) {
    const auto id = counts.Take<std::uint32_t>("a connection");
    directory->AddMessages(id, counts.Take<std::uint32_t>("a count"), counts);
    chunk.ids.push_back(id);
  }
  directory->AddTimes(chunk);
  directory->chunks.push_back(std::move(chunk));
}

void ReadIndex(const ByteFile& file, std::int64_t byte, ChunkDirectory* directory) {
  while (byte < file.size()) {
    const FileRecord record = ReadRecord(file, byte);
    const std::uint8_t operation = HeaderOf(file, record).operation();
    if (operation == kConnection) AddConnection(file, record, directory);
    if (operation == kChunkInfo) AddIndexedChunk(file, record, directory);
    byte = record.end();
  }
}

void ReadThrough(const ByteFile& file, std::int64_t byte, ChunkDirectory* directory) {
  directory->contents.unclosed = true;
  while (byte < file.size()) {
    directory->contents.cut_off_bytes = file.size() - byte;
    FileRecord record;
    try {
      record = ReadRecord(file, byte);
    } catch (const BagError&) {
      return;  // where the recorder was stopped
    }
    if (record.end() > file.size()) return;
    const std::uint8_t operation = HeaderOf(file, record).operation();
    if (operation == kChunk) {
      // The sizes of a chunk are written when it is full.
      if (record.data_bytes == 0) return;
      directory->AddByReading(file, ChunkOf(file, record), ParseChunk);
    }
    if (operation == kConnection) AddConnection(file, record, directory);
    byte = record.end();
  }
  directory->contents.cut_off_bytes = 0;
}

}  // namespace

std::unique_ptr<MessageSource> OpenRos1Bag(const ByteFile& file) {
  const std::string first_line = file.ReadUpTo(0, static_cast<std::int64_t>(kFirstLine.size()));
  if (first_line != kFirstLine) {
    throw BagError(file.path(), 0,
                   "expected a bag of format 2.0, found another one (rosbag fix may convert it)");
  }
  const FileRecord first = ReadRecord(file, static_cast<std::int64_t>(kFirstLine.size()));
  const Header header = HeaderOf(file, first);
  if (header.operation() != kBagHeader) header.at().Fail("expected the bag's header");
  if (header.TryField("encryptor")) {
    ByteCursor encryptor = *header.TryField("encryptor");
    if (!encryptor.empty()) header.at().Fail("expected a bag that is not encrypted");
  }
  const auto index = header.Get<std::uint64_t>("index_pos");
  if (index > static_cast<std::uint64_t>(file.size())) {
    header.at().Fail("expected a whole bag with its index at byte " + std::to_string(index) +
                     ", found the end of the file at byte " + std::to_string(file.size()) +
                     ": it was cut off (rosbag reindex saves what is left)");
  }
  ChunkDirectory directory;
  if (index == 0) {
    ReadThrough(file, first.end(), &directory);
  } else {
    ReadIndex(file, static_cast<std::int64_t>(index), &directory);
    if (directory.chunks.size() != header.Get<std::uint32_t>("chunk_count")) {
      header.at().Fail("expected an index of " +
                       std::to_string(header.Get<std::uint32_t>("chunk_count")) +
                       " chunks, found one of " + std::to_string(directory.chunks.size()));
    }
  }
  directory.contents.format = "ROS 1 bag, " + std::to_string(directory.chunks.size()) + " chunks";
  return std::make_unique<ChunkedBag>(file, std::move(directory), ParseChunk);
}

}  // namespace gmapping_spa::rosbag
