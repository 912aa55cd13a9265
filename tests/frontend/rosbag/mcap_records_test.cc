// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/mcap_records.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/conversion/message_bytes.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::rosbag {
namespace {

using conversion::AppendNumber;
using conversion::AppendPrefixed;
using ::testing::HasSubstr;

std::string McapBytes(McapOpcode opcode, const std::string& data) {
  std::string record(1, static_cast<char>(opcode));
  AppendNumber(std::uint64_t{data.size()}, &record);
  return record + data;
}

std::string SchemaBytes(std::uint16_t id, const char* type) {
  std::string data;
  AppendNumber(id, &data);
  for (const char* text : {type, "ros2msg", ""}) AppendPrefixed(text, &data);
  return McapBytes(McapOpcode::kSchema, data);
}

std::string ChannelBytes(std::uint16_t id, std::uint16_t schema, const char* encoding) {
  std::string data, metadata;
  for (const char* text : {"md5sum", "0123"}) AppendPrefixed(text, &metadata);
  AppendNumber(id, &data);
  AppendNumber(schema, &data);
  for (const std::string& text : {std::string("/scan"), std::string(encoding), metadata}) {
    AppendPrefixed(text, &data);
  }
  return McapBytes(McapOpcode::kChannel, data);
}

std::string MessageRecord(std::uint16_t channel, std::uint64_t time_ns, const char* message) {
  std::string data;
  AppendNumber(channel, &data);
  AppendNumber(std::uint32_t{0}, &data);
  AppendNumber(time_ns, &data);
  AppendNumber(std::uint64_t{99}, &data);  // of publication
  return McapBytes(McapOpcode::kMessage, data + message);
}

struct SeenRecords : ChunkVisitor {
  void OnTopic(std::uint32_t id, BagTopic topic, const ByteCursor& /*at*/) override {
    topics[id] = std::move(topic);
  }
  void OnMessage(std::uint32_t id, std::int64_t time_ns, std::string_view data,
                 const ByteCursor& /*at*/) override {
    messages.push_back(std::to_string(id) + " at " + std::to_string(time_ns) + ": " +
                       std::string(data));
  }
  std::map<std::uint32_t, BagTopic> topics;
  std::vector<std::string> messages;
};

class McapRecordsTest : public testing::Test {
 protected:
  void Parse(const std::string& bytes) { parse_(ByteCursor(bytes, file_name_, 100, 0), &seen_); }
  ByteFile FileOf(const std::string& bytes) { return ByteFile(folder_.FileWith("log", bytes)); }
  // A chunk whose record says that it has so many bytes; it has four.
  std::string ErrorOfChunk(const char* packing, std::uint64_t packed_bytes) {
    std::string data;
    for (const std::uint64_t number : {1, 2, 4}) AppendNumber(number, &data);
    AppendNumber(std::uint32_t{0}, &data);
    AppendPrefixed(packing, &data);
    AppendNumber(packed_bytes, &data);
    const ByteFile file = FileOf(McapBytes(McapOpcode::kChunk, data + "four"));
    return MessageOf([&] { McapChunk(file, ReadMcapRecord(file, 0).value()); });
  }

  const std::string file_name_ = "log";
  TemporaryFolder folder_;
  ChunkParser parse_ = MakeMcapParser();
  SeenRecords seen_;
};

TEST_F(McapRecordsTest, SchemasOfAFormerChunkHoldInLaterOnes) {
  Parse(SchemaBytes(3, "sensor_msgs/msg/LaserScan"));
  Parse(ChannelBytes(0, 3, "cdr") + MessageRecord(0, 17, "hello"));
  EXPECT_EQ(seen_.topics.at(0).name, "/scan");
  EXPECT_EQ(seen_.topics.at(0).type, "sensor_msgs/LaserScan");
  EXPECT_THAT(seen_.messages, testing::ElementsAre("0 at 17: hello"));
}

TEST_F(McapRecordsTest, ChannelOfASchemaThatNeverCameIsAnError) {
  EXPECT_THAT(MessageOf([&] { Parse(ChannelBytes(0, 3, "cdr")); }),
              HasSubstr("expected a channel of a schema before it, found the schema 3"));
  Parse(ChannelBytes(1, 0, "json"));
  EXPECT_EQ(seen_.topics.at(1).type, "") << "0 stands for no schema";
}

TEST_F(McapRecordsTest, EncodingIsThatOfTheChannelAndRos1TellsAnMd5Sum) {
  Parse(ChannelBytes(0, 0, "ros1") + ChannelBytes(1, 0, "cdr") + ChannelBytes(2, 0, "protobuf"));
  EXPECT_EQ(seen_.topics.at(0).encoding, Encoding::kRos1);
  EXPECT_EQ(seen_.topics.at(0).md5sum, "0123");
  EXPECT_EQ(seen_.topics.at(1).encoding, Encoding::kCdr);
  EXPECT_EQ(seen_.topics.at(1).md5sum, "");
  EXPECT_EQ(seen_.topics.at(2).encoding, Encoding::kUnknown);
}

TEST_F(McapRecordsTest, OtherRecordsAreLeftOut) {
  const std::string bytes = McapBytes(static_cast<McapOpcode>(0x09), "an attachment") +
                            MessageRecord(5, 1, "a") + ChannelBytes(0, 0, "cdr") +
                            McapBytes(static_cast<McapOpcode>(0xF0), "") + MessageRecord(5, 2, "");
  ParseMcapMessages(ByteCursor(bytes, file_name_, 0), &seen_);
  EXPECT_THAT(seen_.messages, testing::ElementsAre("5 at 1: a", "5 at 2: "));
  EXPECT_TRUE(seen_.topics.empty());
}

TEST_F(McapRecordsTest, RecordThatReachesBeyondItsChunkIsAnError) {
  std::string bytes = MessageRecord(0, 1, "hello");
  bytes.pop_back();
  EXPECT_EQ(MessageOf([&] { Parse(bytes); }),
            "log: byte 100: in this chunk, byte 9: expected 27 bytes of a record, found 26");
}

TEST_F(McapRecordsTest, RecordThatTheFileCutsOffIsNone) {
  const std::string bytes = MessageRecord(0, 1, "hello");
  EXPECT_EQ(ReadMcapRecord(FileOf("...." + bytes), 4)->end(), 4 + std::ssize(bytes));
  EXPECT_FALSE(ReadMcapRecord(FileOf(bytes.substr(0, bytes.size() - 1)), 0));
  EXPECT_FALSE(ReadMcapRecord(FileOf(bytes.substr(0, 8)), 0));
  EXPECT_FALSE(ReadMcapRecord(FileOf(std::string(20, '\xff')), 0));
}

TEST_F(McapRecordsTest, ChunkHasARecordOfItsSizeAndAPackingOfMcap) {
  EXPECT_EQ(ErrorOfChunk("lz4", 4), "no error");
  EXPECT_THAT(ErrorOfChunk("lz4", 5), HasSubstr("expected a chunk of 4 bytes"));
  EXPECT_THAT(ErrorOfChunk("", 3), HasSubstr("expected a chunk of 4 bytes"));
  for (const char* other : {"bz2", "gzip"}) {
    EXPECT_THAT(ErrorOfChunk(other, 4), HasSubstr("packed by none, lz4 or zstd")) << other;
  }
  EXPECT_THAT(ErrorOfChunk(std::string(300, 'z').c_str(), 4), HasSubstr("bytes of a compression"));
}

}  // namespace
}  // namespace gmapping_spa::rosbag
