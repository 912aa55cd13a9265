// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/record_fields.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "tests/message_of.h"

namespace gmapping_spa::sensor {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(RecordFields, AreSeparatedByBlanksAndTabs) {
  RecordFields fields("  ODOM \t 1.5");
  EXPECT_EQ(fields.TryWord(), "ODOM");
  EXPECT_EQ(fields.Number("x"), 1.5);
  EXPECT_EQ(fields.TryWord(), "");
}

TEST(RecordFields, PoseIsReadInOrderAndItsAngleWrapped) {
  const backend::SE2 pose = RecordFields("1 -2 7").Pose("pose");
  EXPECT_EQ(pose.x, 1.0);
  EXPECT_EQ(pose.y, -2.0);
  EXPECT_NEAR(pose.theta, 7.0 - 2.0 * M_PI, 1e-12);
}

TEST(RecordFields, CountedNumbersEndWhereTheCountSays) {
  RecordFields fields("3 1 2 3 4");
  EXPECT_THAT(fields.CountedNumbers("ranges"), ElementsAre(1.0, 2.0, 3.0));
  EXPECT_EQ(fields.Word("rest"), "4");
}

TEST(RecordFields, CountLargerThanTheLineIsToldBeforeAnyMemoryIsAskedFor) {
  EXPECT_THAT(MessageOf<MalformedRecord>(
                  [] { RecordFields("99999999999999 1 2").CountedNumbers("ranges"); }),
              HasSubstr("expected 99999999999999 ranges, found a shorter line"));
}

TEST(RecordFields, NumberThatNoDoubleHoldsIsNan) {
  EXPECT_TRUE(std::isnan(RecordFields("1e999").Number("range")));
  EXPECT_TRUE(std::isnan(RecordFields("nan").Number("range")));
}

TEST(RecordFields, CoordinatesAndStampsMustBeFiniteAndOfSaneSize) {
  for (const char* word : {"nan", "inf", "-inf", "1e999"}) {
    EXPECT_THAT(MessageOf<MalformedRecord>([&] { RecordFields(word).FiniteNumber("x"); }),
                HasSubstr("a finite x"))
        << word;
  }
  EXPECT_THAT(MessageOf<MalformedRecord>([&] { RecordFields("1e10").FiniteNumber("x"); }),
              HasSubstr("x of at most 1e+09"));
  EXPECT_EQ(RecordFields("1e10").Stamp(), 1e10);
  EXPECT_THROW(RecordFields("1e13").Stamp(), MalformedRecord);
}

TEST(RecordFields, MissingFieldAndOtherWordAreNamed) {
  EXPECT_THAT(MessageOf<MalformedRecord>([] { RecordFields(" ").Word("host"); }),
              HasSubstr("host"));
  EXPECT_THAT(MessageOf<MalformedRecord>([] { RecordFields("1.5x").Number("range"); }),
              HasSubstr("'1.5x'"));
  EXPECT_THAT(MessageOf<MalformedRecord>([] { RecordFields("-1 2").CountedNumbers("ranges"); }),
              HasSubstr("number of ranges"));
}

}  // namespace
}  // namespace gmapping_spa::sensor
