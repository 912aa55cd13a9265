// SPDX-License-Identifier: BSD-3-Clause
// Bags that are files of chunks: ROS 1 bags and MCAP.
#ifndef GMAPPING_SPA_FRONTEND_ROSBAG_CHUNKED_BAG_H_
#define GMAPPING_SPA_FRONTEND_ROSBAG_CHUNKED_BAG_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "frontend/rosbag/byte_cursor.h"
#include "frontend/rosbag/byte_file.h"
#include "frontend/rosbag/message_source.h"
#include "frontend/rosbag/unpack.h"

namespace gmapping_spa::rosbag {

// A chunk, or a run of messages that lie in the file as they are.
struct Chunk {
  std::int64_t byte = 0;       // of its record
  std::int64_t data_byte = 0;  // of what it holds
  std::uint64_t packed_bytes = 0, bytes = 0;
  Packing packing = Packing::kNone;
  std::uint32_t crc = 0;  // CRC-32 of what it unpacks to; 0: not known
  std::int64_t first_ns = 0, last_ns = 0;
  // Which ids of topics (connections, channels) it has messages of; empty where not known.
  std::vector<std::uint32_t> ids;
};

// Takes what a chunk holds.
class ChunkVisitor {
 public:
  virtual ~ChunkVisitor() = default;
  virtual void OnTopic(std::uint32_t id, BagTopic topic, const ByteCursor& at) = 0;
  virtual void OnMessage(std::uint32_t id, std::int64_t time_ns, std::string_view data,
                         const ByteCursor& at) = 0;
};

// Hands on the records of an unpacked chunk. Throws BagError.
using ChunkParser = std::function<void(ByteCursor records, ChunkVisitor* visitor)>;

// What is known of a bag before its messages are read.
struct ChunkDirectory {
  BagContents contents;
  std::vector<Chunk> chunks;
  std::map<std::uint32_t, std::size_t> topic_of_id;
  std::uint64_t read_bytes = 0;  // of chunks, by AddByReading

  // A topic that is recorded by several connections is one. Throws BagError when the id is taken.
  void AddTopic(std::uint32_t id, BagTopic topic, const ByteCursor& at);
  void AddMessages(std::uint32_t id, std::int64_t count, const ByteCursor& at);
  // The topic of an id. Throws BagError where it is not known.
  std::size_t TopicOf(std::uint32_t id, const ByteCursor& at) const;
  // Unpacks and parses a chunk whose times and topics are not known, and adds it with these.
  void AddByReading(const ByteFile& file, Chunk chunk, const ChunkParser& parse);
  // Adds those times to the contents' own.
  void AddTimes(const Chunk& chunk);
};

// Unpacks, and checks the CRC. Adds its bytes to those that were unpacked before. Throws BagError,
// also where these are more in all than a file of this size may have.
std::string ReadChunk(const ByteFile& file, const Chunk& chunk, std::uint64_t* unpacked_bytes);

// Merges chunks by time: all those that begin before the next message ends are held unpacked, up to
// 512 MiB of them; where more overlap, messages come later than others that are younger.
class ChunkedBag : public MessageSource {
 public:
  ChunkedBag(ByteFile file, ChunkDirectory directory, ChunkParser parse);

  const BagContents& contents() const override { return directory_.contents; }
  void Select(const std::vector<bool>& wanted) override;
  std::optional<BagMessage> Next() override;

 private:
  struct OpenChunk {
    std::string bytes;
    std::int64_t byte = 0;
    std::vector<BagMessage> messages;  // in the order of time
    std::size_t next = 0;
  };
  using Head = std::tuple<std::int64_t, std::size_t>;  // time of the next message, chunk

  bool IsWanted(const Chunk& chunk) const;
  void Open(std::size_t position);

  ByteFile file_;
  ChunkDirectory directory_;  // chunks in the order of time
  ChunkParser parse_;
  std::vector<bool> wanted_;
  std::size_t next_chunk_ = 0;
  std::map<std::size_t, OpenChunk> open_;
  std::priority_queue<Head, std::vector<Head>, std::greater<>> heads_;
  std::uint64_t open_bytes_ = 0, unpacked_bytes_ = 0;
  std::optional<std::size_t> finished_;  // the chunk of the last message, when that was its last
};

}  // namespace gmapping_spa::rosbag

#endif  // GMAPPING_SPA_FRONTEND_ROSBAG_CHUNKED_BAG_H_
