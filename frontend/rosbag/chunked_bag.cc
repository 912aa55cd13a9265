// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/chunked_bag.h"

#include <algorithm>
#include <set>
#include <utility>

namespace gmapping_spa::rosbag {
namespace {

constexpr std::uint64_t kMaxOpenBytes = 2 * kMaxChunkBytes;
// No disk holds as many; what an index says beyond is a fault, whose sums would overflow.
constexpr std::int64_t kMostMessages = 1'000'000'000'000;

class DirectoryVisitor : public ChunkVisitor {
 public:
  DirectoryVisitor(ChunkDirectory* directory, Chunk* chunk)
      : directory_(directory), chunk_(chunk) {}

  void OnTopic(std::uint32_t id, BagTopic topic, const ByteCursor& at) override {
    directory_->AddTopic(id, std::move(topic), at);
  }
  void OnMessage(std::uint32_t id, std::int64_t time_ns, std::string_view /*data*/,
                 const ByteCursor& at) override {
    directory_->AddMessages(id, 1, at);
    chunk_->first_ns = ids_.empty() ? time_ns : std::min(chunk_->first_ns, time_ns);
    chunk_->last_ns = ids_.empty() ? time_ns : std::max(chunk_->last_ns, time_ns);
    ids_.insert(id);
  }
  const std::set<std::uint32_t>& ids() const { return ids_; }

 private:
  ChunkDirectory* directory_;
  Chunk* chunk_;
  std::set<std::uint32_t> ids_;
};

class MessageCollector : public ChunkVisitor {
 public:
  MessageCollector(const ChunkDirectory& directory, const std::vector<bool>& wanted)
      : directory_(directory), wanted_(wanted) {}

  void OnTopic(std::uint32_t /*id*/, BagTopic /*topic*/, const ByteCursor& /*at*/) override {}
  void OnMessage(std::uint32_t id, std::int64_t time_ns, std::string_view data,
                 const ByteCursor& at) override {
    const std::size_t topic = directory_.TopicOf(id, at);
    if (wanted_[topic]) messages_.push_back({.topic = topic, .time_ns = time_ns, .data = data});
  }
  std::vector<BagMessage>& messages() { return messages_; }

 private:
  const ChunkDirectory& directory_;
  const std::vector<bool>& wanted_;
  std::vector<BagMessage> messages_;
};

}  // namespace

std::string Ros1TypeName(std::string_view type) {
  std::string name(type);
  if (const std::size_t found = name.find("/msg/"); found != std::string::npos) {
    name.erase(found, 4);
  }
  return name;
}

void ChunkDirectory::AddTopic(std::uint32_t id, BagTopic topic, const ByteCursor& at) {
  std::size_t position = 0;
  while (position < contents.topics.size() && (contents.topics[position].name != topic.name ||
                                               contents.topics[position].type != topic.type ||
                                               contents.topics[position].md5sum != topic.md5sum)) {
    ++position;
  }
  const auto [known, is_new] = topic_of_id.emplace(id, position);
  if (!is_new && known->second != position) {
    at.Fail("expected topic " + contents.topics[known->second].name + " for the id " +
            std::to_string(id) + ", found another one");
  }
  if (position == contents.topics.size()) contents.topics.push_back(std::move(topic));
}

std::size_t ChunkDirectory::TopicOf(std::uint32_t id, const ByteCursor& at) const {
  const auto found = topic_of_id.find(id);
  if (found == topic_of_id.end()) {
    at.Fail("expected a message of a topic that is declared, found one of the id " +
            std::to_string(id));
  }
  return found->second;
}

void ChunkDirectory::AddMessages(std::uint32_t id, std::int64_t count, const ByteCursor& at) {
  BagTopic& topic = contents.topics[TopicOf(id, at)];
  if (count < 0 || count > kMostMessages - topic.messages) {
    at.Fail("expected at most " + std::to_string(kMostMessages) + " messages of the id " +
            std::to_string(id) + ", found more");
  }
  topic.messages += count;
}

void ChunkDirectory::AddByReading(const ByteFile& file, Chunk chunk, const ChunkParser& parse) {
  const std::string bytes = ReadChunk(file, chunk, &read_bytes);
  DirectoryVisitor visitor(this, &chunk);
  parse(ByteCursor(bytes, file.path(), chunk.byte, 0), &visitor);
  if (visitor.ids().empty()) return;
  chunk.ids.assign(visitor.ids().begin(), visitor.ids().end());
  AddTimes(chunk);
  chunks.push_back(std::move(chunk));
}

void ChunkDirectory::AddTimes(const Chunk& chunk) {
  const bool is_first = chunks.empty();
  contents.first_ns = is_first ? chunk.first_ns : std::min(contents.first_ns, chunk.first_ns);
  contents.last_ns = is_first ? chunk.last_ns : std::max(contents.last_ns, chunk.last_ns);
}

std::string ReadChunk(const ByteFile& file, const Chunk& chunk, std::uint64_t* unpacked_bytes) {
  // What cannot be unpacked need not be read.
  if (chunk.bytes > kMaxChunkBytes || chunk.packed_bytes > 2 * kMaxChunkBytes) {
    return Unpack(chunk.packing, "", std::max(chunk.bytes, chunk.packed_bytes), file.path(),
                  chunk.byte);
  }
  *unpacked_bytes += chunk.bytes;
  if (const std::uint64_t most = MostUnpackedBytes(file.size()); *unpacked_bytes > most) {
    throw BagError(file.path(), chunk.byte,
                   "expected chunks of at most " + std::to_string(most) +
                       " bytes in all, as the file has " + std::to_string(file.size()) +
                       ", found more");
  }
  const std::string packed = file.Read(chunk.data_byte, chunk.packed_bytes, "a chunk");
  std::string bytes = Unpack(chunk.packing, packed, chunk.bytes, file.path(), chunk.byte);
  if (chunk.crc != 0 && Crc32(bytes) != chunk.crc) {
    throw BagError(file.path(), chunk.byte,
                   "expected a chunk with the CRC " + std::to_string(chunk.crc) + ", found " +
                       std::to_string(Crc32(bytes)));
  }
  return bytes;
}

ChunkedBag::ChunkedBag(ByteFile file, ChunkDirectory directory, ChunkParser parse)
    : file_(std::move(file)), directory_(std::move(directory)), parse_(std::move(parse)) {
  directory_.contents.bytes = file_.size();
  std::stable_sort(directory_.chunks.begin(), directory_.chunks.end(),
                   [](const Chunk& a, const Chunk& b) { return a.first_ns < b.first_ns; });
  Select(std::vector<bool>(contents().topics.size(), true));
}

void ChunkedBag::Select(const std::vector<bool>& wanted) {
  wanted_ = wanted;
  next_chunk_ = 0;
  open_.clear();
  heads_ = {};
  open_bytes_ = unpacked_bytes_ = 0;
  finished_.reset();
}

bool ChunkedBag::IsWanted(const Chunk& chunk) const {
  return chunk.ids.empty() || std::ranges::any_of(chunk.ids, [&](std::uint32_t id) {
           const auto found = directory_.topic_of_id.find(id);
           return found == directory_.topic_of_id.end() || wanted_[found->second];
         });
}

void ChunkedBag::Open(std::size_t position) {
  const Chunk& chunk = directory_.chunks[position];
  if (!IsWanted(chunk)) return;
  OpenChunk opened{ReadChunk(file_, chunk, &unpacked_bytes_), chunk.byte, {}, 0};
  // Short strings move when their owner does; so the chunk takes its place before it is parsed.
  OpenChunk& open = open_.emplace(position, std::move(opened)).first->second;
  MessageCollector collector(directory_, wanted_);
  parse_(ByteCursor(open.bytes, file_.path(), chunk.byte, 0), &collector);
  open.messages = std::move(collector.messages());
  std::stable_sort(open.messages.begin(), open.messages.end(),
                   [](const BagMessage& a, const BagMessage& b) { return a.time_ns < b.time_ns; });
  if (open.messages.empty()) {
    open_.erase(position);
    return;
  }
  open_bytes_ += chunk.bytes;
  heads_.emplace(open.messages.front().time_ns, position);
}

std::optional<BagMessage> ChunkedBag::Next() {
  if (finished_) {
    open_bytes_ -= directory_.chunks[*finished_].bytes;
    open_.erase(*finished_);
    finished_.reset();
  }
  const std::vector<Chunk>& chunks = directory_.chunks;
  while (next_chunk_ < chunks.size() &&
         (heads_.empty() || (chunks[next_chunk_].first_ns <= std::get<0>(heads_.top()) &&
                             open_bytes_ + chunks[next_chunk_].bytes <= kMaxOpenBytes))) {
    Open(next_chunk_++);
  }
  if (heads_.empty()) return std::nullopt;
  const std::size_t position = std::get<1>(heads_.top());
  heads_.pop();
  OpenChunk& open = open_.at(position);
  BagMessage message = open.messages[open.next++];
  message.file = &file_.path();
  message.place = open.byte;
  if (open.next == open.messages.size()) {
    finished_ = position;
  } else {
    heads_.emplace(open.messages[open.next].time_ns, position);
  }
  return message;
}

}  // namespace gmapping_spa::rosbag
