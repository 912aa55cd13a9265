// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/ros1_bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4frame.h>

#include "tests/frontend/rosbag/small_bag.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::rosbag {
namespace {

using conversion::AppendNumber;
using conversion::AppendPrefixed;
using ::testing::HasSubstr;

// A record whose header has these fields, each name=value.
std::string Ros1Record(const std::vector<std::string>& fields, const std::string& data) {
  std::string header, record;
  for (const std::string& field : fields) AppendPrefixed(field, &header);
  AppendPrefixed(header, &record);
  AppendPrefixed(data, &record);
  return record;
}

std::string BagWithoutIndex(const std::string& records, const std::string& encryptor = "") {
  const std::string zeros(8, '\0');
  return "#ROSBAG V2.0\n" +
         Ros1Record({"op=\x03", "index_pos=" + zeros, "encryptor=" + encryptor}, "") + records;
}

class Ros1BagTest : public testing::Test {
 protected:
  std::unique_ptr<MessageSource> Open(const std::string& bytes) {
    return OpenRos1Bag(ByteFile(folder_.FileWith("log", bytes)));
  }
  std::string ErrorOf(const std::string& bytes) {
    return MessageOf([&] { Open(bytes); });
  }
  std::string DriveBytes() {
    SmallBag bag(folder_.Path("drive"), "bag");
    WriteDrive(&bag);
    return BytesOf(bag.Finish());
  }
  // With `value` after the first `name` in it.
  std::string DriveWith(const std::string& name, const std::string& value) {
    std::string bytes = DriveBytes();
    return bytes.replace(bytes.find(name) + name.size(), value.size(), value);
  }

  TemporaryFolder folder_;
};

TEST_F(Ros1BagTest, OtherFormatsAndEncryptedBagsAreRefused) {
  EXPECT_THAT(ErrorOf("#ROSBAG V1.2\n"), HasSubstr("byte 0: expected a bag of format 2.0"));
  EXPECT_THAT(ErrorOf(BagWithoutIndex("", "rosbag/AesCbcEncryptor")),
              HasSubstr("expected a bag that is not encrypted"));
  EXPECT_THAT(ErrorOf("#ROSBAG V2.0\n" + Ros1Record({"op=\x07"}, "")),
              HasSubstr("expected the bag's header"));
}

TEST_F(Ros1BagTest, IndexThatDoesNotFitTheFileIsAnError) {
  EXPECT_EQ(ErrorOf(DriveBytes()), "no error");
  EXPECT_THAT(ErrorOf(DriveWith("chunk_count=", "\x02")),
              HasSubstr("expected an index of 2 chunks, found one of 1"));
  EXPECT_THAT(ErrorOf(DriveWith("chunk_pos=", std::string(7, '\x7f'))),
              HasSubstr("expected a chunk within the file, found its place at byte 35"));
  EXPECT_THAT(ErrorOf(DriveWith("chunk_pos=", std::string("\x0d\0", 2))),
              HasSubstr("expected a chunk, found another record"));
}

TEST_F(Ros1BagTest, FieldsOfARecordAreNamedAndOfTheirSize) {
  EXPECT_THAT(ErrorOf(DriveWith("compression=", "zstd")),
              HasSubstr("expected a chunk packed by none, bz2 or lz4"));
  EXPECT_THAT(ErrorOf(DriveWith("index_po", "z")),
              HasSubstr("expected a record with the field 'index_pos', found none"));
  EXPECT_THAT(ErrorOf(DriveWith("index_pos", ":")), HasSubstr("expected name=value"));
  EXPECT_THAT(ErrorOf("#ROSBAG V2.0\n" + Ros1Record({"op=\x03", "index_pos=1234"}, "")),
              HasSubstr("expected 8 bytes of a number, found 4"));
}

TEST_F(Ros1BagTest, ChunkMayBePackedByLz4AndHaveNoIndex) {
  const std::string bytes = DriveBytes();
  const std::size_t begin = bytes.find("size=") + 9;  // of the length of the chunk
  std::uint32_t size = 0;
  bytes.copy(reinterpret_cast<char*>(&size), sizeof(size), begin);
  std::string packed(LZ4F_compressFrameBound(size, nullptr), '\0');
  packed.resize(
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data() + begin + 4, size, nullptr));
  const std::string size_field = "size=" + bytes.substr(begin, 4);
  const std::string chunk = Ros1Record({"op=\x05", "compression=lz4", size_field}, packed);
  EXPECT_EQ(Open(BagWithoutIndex(chunk))->contents().cut_off_bytes, 0);
  const auto source = Open(BagWithoutIndex(chunk + "cut"));
  EXPECT_EQ(source->contents().cut_off_bytes, 3);
  EXPECT_EQ(source->contents().first_ns, kSecond_ns);
  int messages = 0;
  while (source->Next()) ++messages;
  EXPECT_EQ(messages, 10);
}

TEST_F(Ros1BagTest, BagThatHardlyBeganHasNoMessages) {
  const auto source = Open(BagWithoutIndex(""));
  EXPECT_TRUE(source->contents().unclosed);
  EXPECT_EQ(source->contents().cut_off_bytes, 0);
  EXPECT_FALSE(source->Next());
}

TEST_F(Ros1BagTest, TopicThatSeveralNodesPublishIsOne) {
  std::ofstream out(folder_.Path("tf"), std::ios::binary);
  conversion::Ros1BagWriter writer(out, false);
  const int first = writer.AddTopic("/tf", "tf2_msgs/TFMessage");
  const int second = writer.AddTopic("/tf", "tf2_msgs/TFMessage");
  writer.Write(second, 2 * kSecond_ns, "b");
  writer.Write(first, 1 * kSecond_ns, "a");
  writer.Finish();
  out.close();
  const auto source = OpenRos1Bag(ByteFile(folder_.Path("tf")));
  ASSERT_EQ(source->contents().topics.size(), 1u);
  EXPECT_EQ(source->contents().topics[0].messages, 2);
  EXPECT_EQ(source->Next()->data, "a");
  EXPECT_EQ(source->Next()->data, "b");
}

}  // namespace
}  // namespace gmapping_spa::rosbag
