// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/packed_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include "frontend/sensor/record_fields.h"
#include "tests/message_of.h"

namespace gmapping_spa::rosbag {
namespace {

using ::testing::HasSubstr;

class PackedMessageTest : public testing::Test {
 protected:
  std::string Unpacked(std::string_view data, std::uint64_t most = 1 << 20) {
    return UnpackMessage({.data = data, .file = &file_}, most);
  }

  std::string ErrorOf(std::string_view data, std::uint64_t most = 1 << 20) {
    return MessageOf<sensor::MalformedRecord>([&] { Unpacked(data, most); });
  }

  static std::string Packed(const std::string& text) {
    std::string packed(ZSTD_compressBound(text.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), text.data(), text.size(), 3));
    return packed;
  }

  const std::string file_ = "robot.db3";
  const std::string message_ = std::string(500, 'x') + "a scan";
};

TEST_F(PackedMessageTest, IsUnpacked) { EXPECT_EQ(Unpacked(Packed(message_)), message_); }

TEST_F(PackedMessageTest, OfMoreBytesThanAreLeftIsRefused) {
  EXPECT_THAT(ErrorOf(Packed(message_), message_.size() - 1), HasSubstr("up to 505 bytes"));
}

TEST_F(PackedMessageTest, ThatIsDamagedIsRefused) {
  std::string packed = Packed(message_);
  packed.pop_back();
  EXPECT_THAT(ErrorOf(packed), HasSubstr("found a damaged one"));
  EXPECT_THAT(ErrorOf(packed.substr(0, 5)), HasSubstr("that tells its size"));
}

}  // namespace
}  // namespace gmapping_spa::rosbag
