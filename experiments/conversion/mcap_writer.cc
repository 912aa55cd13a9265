// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/conversion/mcap_writer.h"

#include <zstd.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/conversion/message_bytes.h"
#include "experiments/conversion/message_definitions.h"
#include "frontend/rosbag/mcap_file.h"
#include "frontend/rosbag/mcap_records.h"
#include "frontend/rosbag/unpack.h"

namespace gmapping_spa::conversion {
namespace {

using rosbag::McapOpcode;

constexpr std::size_t kChunkBytes = 768 << 10;  // as rosbag2 has it
constexpr auto kMessageIndex = static_cast<McapOpcode>(0x07);

std::string Record(McapOpcode opcode, std::string_view data) {
  std::string record(1, static_cast<char>(opcode));
  AppendNumber(static_cast<std::uint64_t>(data.size()), &record);
  return record.append(data);
}

std::string PackedByZstd(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3);
  if (ZSTD_isError(size) != 0) throw std::runtime_error("a chunk cannot be packed by zstd");
  packed.resize(size);
  return packed;
}

}  // namespace

McapWriter::McapWriter(std::ostream& out, bool packs) : out_(out), packs_(packs) {
  std::string header;
  AppendPrefixed("ros2", &header);
  AppendPrefixed("gmapping_spa", &header);
  WriteOut(std::string(rosbag::kMcapMagic) + Record(McapOpcode::kHeader, header));
}

void McapWriter::WriteOut(const std::string& bytes) {
  out_ << bytes;
  num_bytes_ += bytes.size();
}

int McapWriter::AddTopic(std::string_view name, std::string_view type) {
  const int id = static_cast<int>(messages_.size());
  const auto schema_id = static_cast<std::uint16_t>(id + 1);  // 0 stands for none
  std::string schema, channel;
  AppendNumber(schema_id, &schema);
  AppendPrefixed(Ros2TypeName(type), &schema);
  AppendPrefixed("ros2msg", &schema);
  AppendPrefixed(DefinitionOf(type, encoding()), &schema);
  AppendNumber(static_cast<std::uint16_t>(id), &channel);
  AppendNumber(schema_id, &channel);
  AppendPrefixed(name, &channel);
  AppendPrefixed("cdr", &channel);
  AppendPrefixed("", &channel);  // metadata
  const std::string declaration =
      Record(McapOpcode::kSchema, schema) + Record(McapOpcode::kChannel, channel);
  declarations_ += declaration;
  chunk_ += declaration;
  messages_.push_back(0);
  return id;
}

void McapWriter::Write(int topic, std::int64_t time_ns, std::string_view message) {
  first_ns_ = index_.empty() ? time_ns : std::min(first_ns_, time_ns);
  last_ns_ = index_.empty() ? time_ns : std::max(last_ns_, time_ns);
  const bool is_first = std::ranges::all_of(messages_, [](std::uint64_t n) { return n == 0; });
  all_first_ns_ = is_first ? time_ns : std::min(all_first_ns_, time_ns);
  all_last_ns_ = is_first ? time_ns : std::max(all_last_ns_, time_ns);
  index_[topic].emplace_back(time_ns, chunk_.size());
  std::string record;
  AppendNumber(static_cast<std::uint16_t>(topic), &record);
  AppendNumber(static_cast<std::uint32_t>(messages_[topic]++), &record);
  AppendNumber(time_ns, &record);
  AppendNumber(time_ns, &record);
  record += message;
  chunk_ += Record(McapOpcode::kMessage, record);
  if (chunk_.size() > kChunkBytes) FinishChunk();
}

void McapWriter::FinishChunk() {
  if (index_.empty()) return;
  const std::string packed = packs_ ? PackedByZstd(chunk_) : chunk_;
  const std::string_view packing = packs_ ? "zstd" : "";
  std::string chunk;
  AppendNumber(first_ns_, &chunk);
  AppendNumber(last_ns_, &chunk);
  AppendNumber(static_cast<std::uint64_t>(chunk_.size()), &chunk);
  AppendNumber(rosbag::Crc32(chunk_), &chunk);
  AppendPrefixed(packing, &chunk);
  AppendNumber(static_cast<std::uint64_t>(packed.size()), &chunk);
  chunk += packed;
  const std::uint64_t chunk_byte = num_bytes_;
  WriteOut(Record(McapOpcode::kChunk, chunk));
  const std::uint64_t indices_byte = num_bytes_;
  std::string offsets;
  for (const auto& [topic, messages] : index_) {
    std::string index, places;
    for (const auto& [time_ns, place] : messages) {
      AppendNumber(time_ns, &places);
      AppendNumber(place, &places);
    }
    AppendNumber(static_cast<std::uint16_t>(topic), &index);
    AppendPrefixed(places, &index);
    AppendNumber(static_cast<std::uint16_t>(topic), &offsets);
    AppendNumber(num_bytes_, &offsets);
    WriteOut(Record(kMessageIndex, index));
  }
  std::string index;
  AppendNumber(first_ns_, &index);
  AppendNumber(last_ns_, &index);
  AppendNumber(chunk_byte, &index);
  AppendNumber(indices_byte - chunk_byte, &index);
  AppendPrefixed(offsets, &index);
  AppendNumber(num_bytes_ - indices_byte, &index);
  AppendPrefixed(packing, &index);
  AppendNumber(static_cast<std::uint64_t>(packed.size()), &index);
  AppendNumber(static_cast<std::uint64_t>(chunk_.size()), &index);
  chunk_indices_ += Record(McapOpcode::kChunkIndex, index);
  ++num_chunks_;
  chunk_.clear();
  index_.clear();
}

std::string McapWriter::Statistics() const {
  std::uint64_t all = 0;
  std::string counts;
  for (std::size_t topic = 0; topic < messages_.size(); ++topic) {
    all += messages_[topic];
    AppendNumber(static_cast<std::uint16_t>(topic), &counts);
    AppendNumber(messages_[topic], &counts);
  }
  std::string statistics;
  AppendNumber(all, &statistics);
  AppendNumber(static_cast<std::uint16_t>(messages_.size()), &statistics);  // schemas
  AppendNumber(static_cast<std::uint32_t>(messages_.size()), &statistics);  // channels
  AppendNumber(std::uint32_t{0}, &statistics);                              // attachments
  AppendNumber(std::uint32_t{0}, &statistics);                              // metadata
  AppendNumber(num_chunks_, &statistics);
  AppendNumber(all_first_ns_, &statistics);
  AppendNumber(all_last_ns_, &statistics);
  AppendPrefixed(counts, &statistics);
  return statistics;
}

void McapWriter::Finish() {
  FinishChunk();
  std::string data_end;
  AppendNumber(std::uint32_t{0}, &data_end);  // no CRC
  WriteOut(Record(McapOpcode::kDataEnd, data_end));
  const std::uint64_t summary_byte = num_bytes_;
  const std::string summary =
      declarations_ + Record(McapOpcode::kStatistics, Statistics()) + chunk_indices_;
  std::string footer;
  AppendNumber(summary_byte, &footer);
  AppendNumber(std::uint64_t{0}, &footer);  // no offsets of the summary's parts
  std::string checked = summary + Record(McapOpcode::kFooter, footer + "CRC.");
  checked.resize(checked.size() - sizeof(std::uint32_t));
  AppendNumber(rosbag::Crc32(checked), &footer);
  WriteOut(summary + Record(McapOpcode::kFooter, footer) + std::string(rosbag::kMcapMagic));
}

}  // namespace gmapping_spa::conversion
