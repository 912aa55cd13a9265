// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/conversion/ros1_bag_writer.h"

#include <bzlib.h>

#include <algorithm>
#include <stdexcept>

#include "experiments/conversion/message_bytes.h"
#include "experiments/conversion/message_definitions.h"
#include "frontend/rosbag/ros_messages.h"

namespace gmapping_spa::conversion {
namespace {

constexpr std::size_t kChunkBytes = 768 << 10;    // as rosbag has it
constexpr std::size_t kHeaderRecordBytes = 4096;  // without the two lengths
constexpr std::string_view kFirstLine = "#ROSBAG V2.0\n";

// name=value fields, each behind its length.
class Fields {
 public:
  Fields& Text(std::string_view name, std::string_view value) {
    std::string field(name);
    field += '=';
    field += value;
    AppendPrefixed(field, &bytes_);
    return *this;
  }
  template <typename Number>
  Fields& Put(std::string_view name, Number number) {
    std::string value;
    AppendNumber(number, &value);
    return Text(name, value);
  }
  Fields& Time(std::string_view name, std::int64_t time_ns) {
    std::string value;
    AppendNumber(static_cast<std::uint32_t>(time_ns / 1000000000), &value);
    AppendNumber(static_cast<std::uint32_t>(time_ns % 1000000000), &value);
    return Text(name, value);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

Fields Operation(std::uint8_t operation) { return Fields().Put("op", operation); }

void AppendRecord(const Fields& header, std::string_view data, std::string* bytes) {
  AppendPrefixed(header.bytes(), bytes);
  AppendPrefixed(data, bytes);
}

std::string PackedByBz2(const std::string& bytes) {
  // The library's own bound.
  std::string packed(bytes.size() + bytes.size() / 100 + 600, '\0');
  auto size = static_cast<unsigned int>(packed.size());
  if (BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(bytes.data()),
                               static_cast<unsigned int>(bytes.size()), 9, 0, 0) != BZ_OK) {
    throw std::runtime_error("a chunk cannot be packed by bz2");
  }
  packed.resize(size);
  return packed;
}

}  // namespace

Ros1BagWriter::Ros1BagWriter(std::ostream& out, bool packs) : out_(out), packs_(packs) {
  out_ << kFirstLine;
  WriteBagHeader(0);
}

void Ros1BagWriter::WriteBagHeader(std::uint64_t index_byte) {
  const Fields header = Operation(3)
                            .Put("index_pos", index_byte)
                            .Put("conn_count", static_cast<std::uint32_t>(connections_.size()))
                            .Put("chunk_count", num_chunks_);
  // Blanks leave room for other sizes of the fields.
  const std::string blanks(kHeaderRecordBytes - header.bytes().size(), ' ');
  std::string record;
  AppendRecord(header, blanks, &record);
  out_ << record;
}

int Ros1BagWriter::AddTopic(std::string_view name, std::string_view type) {
  const int id = static_cast<int>(connections_.size());
  Fields data;
  data.Text("topic", name)
      .Text("type", type)
      .Text("md5sum", rosbag::Md5SumOf(rosbag::TypeNamed(type)))
      .Text("message_definition", DefinitionOf(type, encoding()));
  std::string record;
  AppendRecord(Operation(7).Put("conn", id).Text("topic", name), data.bytes(), &record);
  connections_.push_back(record);
  chunk_ += record;
  return id;
}

void Ros1BagWriter::Write(int topic, std::int64_t time_ns, std::string_view message) {
  first_ns_ = index_.empty() ? time_ns : std::min(first_ns_, time_ns);
  last_ns_ = index_.empty() ? time_ns : std::max(last_ns_, time_ns);
  index_[topic].emplace_back(time_ns, static_cast<std::uint32_t>(chunk_.size()));
  AppendRecord(Operation(2).Put("conn", topic).Time("time", time_ns), message, &chunk_);
  if (chunk_.size() > kChunkBytes) FinishChunk();
}

void Ros1BagWriter::FinishChunk() {
  if (index_.empty()) return;
  const auto byte = static_cast<std::uint64_t>(out_.tellp());
  std::string record, counts;
  AppendRecord(Operation(5)
                   .Text("compression", packs_ ? "bz2" : "none")
                   .Put("size", static_cast<std::uint32_t>(chunk_.size())),
               packs_ ? PackedByBz2(chunk_) : chunk_, &record);
  for (const auto& [topic, messages] : index_) {
    std::string places;
    for (const auto& [time_ns, place] : messages) {
      AppendNumber(static_cast<std::uint32_t>(time_ns / 1000000000), &places);
      AppendNumber(static_cast<std::uint32_t>(time_ns % 1000000000), &places);
      AppendNumber(place, &places);
    }
    const auto count = static_cast<std::uint32_t>(messages.size());
    AppendRecord(Operation(4).Put("ver", 1).Put("conn", topic).Put("count", count), places,
                 &record);
    AppendNumber(topic, &counts);
    AppendNumber(count, &counts);
  }
  out_ << record;
  AppendRecord(Operation(6)
                   .Put("ver", 1)
                   .Put("chunk_pos", byte)
                   .Time("start_time", first_ns_)
                   .Time("end_time", last_ns_)
                   .Put("count", static_cast<std::uint32_t>(index_.size())),
               counts, &chunk_infos_);
  ++num_chunks_;
  chunk_.clear();
  index_.clear();
}

void Ros1BagWriter::Finish() {
  FinishChunk();
  const auto index_byte = static_cast<std::uint64_t>(out_.tellp());
  for (const std::string& connection : connections_) out_ << connection;
  out_ << chunk_infos_;
  out_.seekp(static_cast<std::streamoff>(kFirstLine.size()));
  WriteBagHeader(index_byte);
  out_.seekp(0, std::ios::end);
}

}  // namespace gmapping_spa::conversion
