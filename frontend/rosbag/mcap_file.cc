// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/mcap_file.h"

#include <optional>
#include <string>
#include <utility>

#include "frontend/rosbag/chunked_bag.h"
#include "frontend/rosbag/mcap_records.h"

namespace gmapping_spa::rosbag {
namespace {

constexpr std::int64_t kFooterBytes = 20;
constexpr std::uint64_t kMaxSummaryBytes = kMaxChunkBytes;
constexpr std::int64_t kRunBytes = 1 << 20;  // messages outside of chunks that are read at once

// Takes declarations alone.
class TopicVisitor : public ChunkVisitor {
 public:
  explicit TopicVisitor(ChunkDirectory* directory) : directory_(directory) {}
  void OnTopic(std::uint32_t id, BagTopic topic, const ByteCursor& at) override {
    directory_->AddTopic(id, std::move(topic), at);
  }
  void OnMessage(std::uint32_t /*id*/, std::int64_t /*time_ns*/, std::string_view /*data*/,
                 const ByteCursor& /*at*/) override {}

 private:
  ChunkDirectory* directory_;
};

// What the summary says. Nothing where it does not say all that is needed.
class Summary {
 public:
  explicit Summary(const ByteFile& file) : file_(file) {}

  // `crc` is that of all from the summary to the footer's own CRC; 0 where it is not known.
  std::optional<ChunkDirectory> Read(std::int64_t summary_byte, std::int64_t footer_byte,
                                     std::uint32_t crc) {
    const auto size = static_cast<std::size_t>(footer_byte - summary_byte);
    const std::string with_footer = file_.Read(
        summary_byte, size + McapRecord::kHeaderBytes + kFooterBytes - sizeof(crc), "a summary");
    if (crc != 0 && Crc32(with_footer) != crc) {
      throw BagError(file_.path(), summary_byte, "expected a summary of the CRC in the footer");
    }
    const ByteCursor records(std::string_view(with_footer).substr(0, size), file_.path(),
                             summary_byte);
    TopicVisitor visitor(&directory_);
    MakeMcapParser()(records, &visitor);
    for (ByteCursor rest = records; !rest.empty();) {
      const auto opcode = static_cast<McapOpcode>(rest.Take<std::uint8_t>("an opcode"));
      const auto length = rest.Take<std::uint64_t>("a length");
      const ByteCursor record = rest.Part(length, "a record");
      if (opcode == McapOpcode::kStatistics) ReadStatistics(record);
      if (opcode == McapOpcode::kChunkIndex) AddChunk(record);
    }
    const bool is_whole = num_chunks_ > 0 && num_chunks_ == directory_.chunks.size() &&
                          num_channels_ == directory_.topic_of_id.size();
    return is_whole ? std::optional(std::move(directory_)) : std::nullopt;
  }

 private:
  void ReadStatistics(ByteCursor record) {
    record.Take<std::uint64_t>("a count");  // of messages
    record.Take<std::uint16_t>("a count");  // of schemas
    num_channels_ = record.Take<std::uint32_t>("a count");
    record.Take<std::uint32_t>("a count");  // of attachments
    record.Take<std::uint32_t>("a count");  // of metadata
    num_chunks_ = record.Take<std::uint32_t>("a count");
    record.Take<std::uint64_t>("a time");
    record.Take<std::uint64_t>("a time");
    for (ByteCursor counts = record.PrefixedCursor("counts"); !counts.empty();) {
      const auto id = counts.Take<std::uint16_t>("a channel's id");
      const auto count = counts.Take<std::uint64_t>("a count");
      // Where channels are not repeated, the summary is not whole.
      if (!directory_.topic_of_id.contains(id)) continue;
      directory_.AddMessages(id, static_cast<std::int64_t>(count), counts);
    }
  }

  void AddChunk(ByteCursor index) {
    index.Take<std::uint64_t>("a time");
    index.Take<std::uint64_t>("a time");
    const auto byte = index.Take<std::uint64_t>("a chunk's place");
    const std::optional<McapRecord> record =
        byte < static_cast<std::uint64_t>(file_.size())
            ? ReadMcapRecord(file_, static_cast<std::int64_t>(byte))
            : std::nullopt;
    if (!record || record->opcode != McapOpcode::kChunk) {
      index.Fail("expected the place of a chunk, found byte " + std::to_string(byte) +
                 ", where there is none");
    }
    Chunk chunk = McapChunk(file_, *record);
    index.Take<std::uint64_t>("a length");
    ByteCursor places = index.PrefixedCursor("a list of channels");
    while (!places.empty()) {
      chunk.ids.push_back(places.Take<std::uint16_t>("a channel's id"));
      places.Take<std::uint64_t>("an offset");
    }
    directory_.AddTimes(chunk);
    directory_.chunks.push_back(std::move(chunk));
  }

  const ByteFile& file_;
  ChunkDirectory directory_;
  std::size_t num_chunks_ = 0, num_channels_ = 0;
};

// The footer and the magic end a file that was closed.
std::optional<ChunkDirectory> ReadSummary(const ByteFile& file, bool* is_closed) {
  const std::int64_t magic_byte = file.size() - static_cast<std::int64_t>(kMcapMagic.size());
  const std::int64_t footer_byte = magic_byte - kFooterBytes - McapRecord::kHeaderBytes;
  *is_closed = footer_byte >= static_cast<std::int64_t>(kMcapMagic.size()) &&
               file.ReadUpTo(magic_byte, 8) == kMcapMagic;
  if (!*is_closed) return std::nullopt;
  const std::string footer =
      file.Read(footer_byte, McapRecord::kHeaderBytes + kFooterBytes, "a footer");
  ByteCursor fields(footer, file.path(), footer_byte);
  if (static_cast<McapOpcode>(fields.Take<std::uint8_t>("an opcode")) != McapOpcode::kFooter ||
      fields.Take<std::uint64_t>("a length") != kFooterBytes) {
    fields.Fail("expected a footer before the end of the file, found another record");
  }
  const auto summary = fields.Take<std::uint64_t>("the summary's place");
  if (summary == 0) return std::nullopt;
  if (summary > static_cast<std::uint64_t>(footer_byte) ||
      footer_byte - summary > kMaxSummaryBytes) {
    fields.Fail("expected a summary within the file, found its place at byte " +
                std::to_string(summary));
  }
  fields.Take<std::uint64_t>("a place");
  return Summary(file).Read(static_cast<std::int64_t>(summary), footer_byte,
                            fields.Take<std::uint32_t>("a CRC"));
}

// Reads the whole file for its topics and chunks.
class FullRead {
 public:
  FullRead(const ByteFile& file, bool is_closed, ChunkDirectory* directory)
      : file_(file), parse_(MakeMcapParser()), directory_(*directory) {
    directory_.contents.unclosed = !is_closed;
  }

  void Read() {
    std::int64_t byte = static_cast<std::int64_t>(kMcapMagic.size());
    while (byte < file_.size()) {
      const std::optional<McapRecord> record = ReadMcapRecord(file_, byte);
      if (!record || record->opcode == McapOpcode::kDataEnd ||
          record->opcode == McapOpcode::kFooter) {
        if (!record) CutOff(byte);
        break;
      }
      if (record->opcode == McapOpcode::kSchema || record->opcode == McapOpcode::kChannel ||
          record->opcode == McapOpcode::kMessage) {
        AddToRun(*record);
      } else if (record->opcode == McapOpcode::kChunk) {
        FinishRun();
        directory_.AddByReading(file_, McapChunk(file_, *record), parse_);
      }
      byte = record->end();
    }
    FinishRun();
  }

 private:
  // A run is read as a chunk without compression; it is empty between runs.
  void AddToRun(const McapRecord& record) {
    if (run_end_ == record.byte && record.end() - run_.byte <= kRunBytes) {
      run_end_ = record.end();
      return;
    }
    FinishRun();
    run_.byte = run_.data_byte = record.byte;
    run_end_ = record.end();
  }

  void FinishRun() {
    if (run_end_ == 0) return;
    run_.bytes = run_.packed_bytes = static_cast<std::uint64_t>(run_end_ - run_.byte);
    directory_.AddByReading(file_, run_, parse_);
    run_end_ = 0;
  }

  void CutOff(std::int64_t byte) {
    if (!directory_.contents.unclosed) {
      throw BagError(file_.path(), byte, "expected a record, found one beyond the end of the file");
    }
    directory_.contents.cut_off_bytes = file_.size() - byte;
  }

  const ByteFile& file_;
  ChunkParser parse_;
  ChunkDirectory& directory_;
  Chunk run_;
  std::int64_t run_end_ = 0;
};

}  // namespace

std::unique_ptr<MessageSource> OpenMcap(const ByteFile& file) {
  bool is_closed = false;
  std::optional<ChunkDirectory> directory = ReadSummary(file, &is_closed);
  if (!directory) FullRead(file, is_closed, &directory.emplace()).Read();
  directory->contents.format = "MCAP, " + std::to_string(directory->chunks.size()) + " chunks";
  return std::make_unique<ChunkedBag>(file, std::move(*directory), ParseMcapMessages);
}

}  // namespace gmapping_spa::rosbag
