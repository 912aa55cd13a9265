// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/message_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frontend/sensor/record_fields.h"
#include "tests/message_of.h"

namespace gmapping_spa::rosbag {
namespace {

using sensor::MalformedRecord;
using namespace std::string_literals;

TEST(MessageFields, AlignsNumbersOfCdrBehindItsHeader) {
  const std::string bytes = "\0\1\0\0\2\0\0\0a\0\0\0\0\0\0\0\0\0\xf0\x3f\3"s;
  MessageFields fields(bytes, Encoding::kCdr);
  EXPECT_EQ(fields.Text("text"), "a");
  EXPECT_EQ(fields.Take<double>("number"), 1.0);
  EXPECT_EQ(fields.Take<std::uint8_t>("byte"), 3);
}

TEST(MessageFields, ReadsCdrOfTheOtherByteOrder) {
  const std::string bytes = "\0\0\0\0\0\0\0\2a\0\0\0\x3f\xf0\0\0\0\0\0\0\0\0\0\1\x40\0\0\0"s;
  MessageFields fields(bytes, Encoding::kCdr);
  EXPECT_EQ(fields.Text("text"), "a");
  EXPECT_EQ(fields.Take<double>("number"), 1.0);
  EXPECT_EQ(fields.Floats("numbers"), std::vector<double>{2.0});
}

TEST(MessageFields, OfRos1HaveNoGaps) {
  const std::string bytes = "\1\0\0\0a\0\0\0\0\0\0\xf0\x3f"s;
  MessageFields fields(bytes, Encoding::kRos1);
  EXPECT_EQ(fields.Text("text"), "a");
  EXPECT_EQ(fields.Take<double>("number"), 1.0);
}

TEST(MessageFields, ThatAreMissingAreSaid) {
  const std::string bytes = "\1\0\0\0a\0"s;
  MessageFields fields(bytes, Encoding::kRos1);
  fields.Text("text");
  EXPECT_EQ(MessageOf<MalformedRecord>([&] { fields.Take<double>("a pose"); }),
            "expected 8 bytes of a pose, found 1 up to the end of the message");
}

TEST(MessageFields, SequenceMustFitIntoTheMessage) {
  const std::string bytes = "\xff\xff\xff\xff\0\0\0\0"s;
  MessageFields fields(bytes, Encoding::kRos1);
  EXPECT_EQ(MessageOf<MalformedRecord>([&] { fields.Floats("ranges"); }),
            "expected 4294967295 ranges, found 4 bytes up to the end of the message");
}

TEST(MessageFields, OtherEncodingsAreRefused) {
  EXPECT_THROW(MessageFields("\0\3\0\0"s, Encoding::kCdr), MalformedRecord);
  EXPECT_THROW(MessageFields("\0\1"s, Encoding::kCdr), MalformedRecord);
}

}  // namespace
}  // namespace gmapping_spa::rosbag
