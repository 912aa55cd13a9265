// SPDX-License-Identifier: BSD-3-Clause
#include "backend/text.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace gmapping_spa::backend {
namespace {

TEST(Text, AByteOrderMarkIsTakenOffOnceAndAtTheFrontOnly) {
  EXPECT_EQ(WithoutByteOrderMark("\xef\xbb\xbf"
                                 "VERTEX"),
            "VERTEX");
  EXPECT_EQ(WithoutByteOrderMark("VERTEX\xef\xbb\xbf"), "VERTEX\xef\xbb\xbf");
  EXPECT_EQ(WithoutByteOrderMark("\xef\xbb"), "\xef\xbb");
  EXPECT_EQ(WithoutByteOrderMark(""), "");
}

TEST(Text, ACommentReachesFromItsSignToTheEnd) {
  EXPECT_EQ(WithoutComment("1 2 3# a # b"), "1 2 3");
  EXPECT_EQ(WithoutComment("# only"), "");
  EXPECT_EQ(WithoutComment("1 2 3"), "1 2 3");
}

TEST(Text, WordsAreTakenUntilNoneIsLeft) {
  std::string_view rest = " one\ttwo \r";
  EXPECT_EQ(TakeWord(&rest), "one");
  EXPECT_EQ(TakeWord(&rest), "two");
  EXPECT_EQ(TakeWord(&rest), "");
  EXPECT_EQ(TakeWord(&rest), "");
}

TEST(Text, QuotedWordsAreShortAndPrintable) {
  EXPECT_EQ(Quoted("VERTEX_XY"), "'VERTEX_XY'");
  EXPECT_EQ(Quoted("a\x01z"), "'a?z'");
  EXPECT_EQ(Quoted(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(Text, WordsOfALineAreAllThereAre) {
  EXPECT_THAT(WordsOf("a  bc\t d "), testing::ElementsAre("a", "bc", "d"));
  EXPECT_THAT(WordsOf(" "), testing::IsEmpty());
}

TEST(Text, ANumberIsAWholeWord) {
  EXPECT_EQ(ParseNumber<double>("-1.5e2"), -150.0);
  EXPECT_EQ(ParseNumber<double>("+3"), 3.0);
  EXPECT_EQ(ParseNumber<std::int64_t>("-7"), -7);
  for (const char* word : {"", "+", "+-3", "1x", " 1", "1 ", "0x10", "1,5", "one"}) {
    EXPECT_EQ(ParseNumber<double>(word), std::nullopt) << word;
  }
  EXPECT_EQ(ParseNumber<std::int64_t>("1.0"), std::nullopt);
  EXPECT_EQ(ParseNumber<std::uint64_t>("-1"), std::nullopt);
}

TEST(Text, ANumberTooLargeForItsTypeIsNanWhereThereIsOne) {
  EXPECT_TRUE(std::isnan(ParseNumber<double>("1e999").value()));
  EXPECT_EQ(ParseNumber<std::int64_t>("99999999999999999999"), std::nullopt);
}

TEST(Text, FiniteNumbersAreFinite) {
  EXPECT_EQ(ParseFinite<double>("2"), 2.0);
  for (const char* word : {"nan", "inf", "-inf", "1e999", "x"}) {
    EXPECT_EQ(ParseFinite<double>(word), std::nullopt) << word;
  }
}

TEST(Text, ShortestTextsReadBackAsTheSameNumber) {
  for (const double number : {0.1, -1.0 / 3.0, 1e-300, 5e-324, 1.7976931348623157e308, 1.2e9}) {
    EXPECT_EQ(ParseNumber<double>(ShortestText(number)), number);
    EXPECT_EQ(ParseNumber<double>(ShortestFixedText(number)), number);
    EXPECT_EQ(ShortestFixedText(number).find('e'), std::string::npos);
  }
  EXPECT_EQ(ShortestText(0.1), "0.1");
  EXPECT_EQ(ShortestFixedText(1e9), "1000000000");
}

TEST(Text, FixedTextHasAsManyDecimalsAsAskedFor) {
  EXPECT_EQ(FixedText(1.0, 3), "1.000");
  EXPECT_EQ(FixedText(-2.345, 1), "-2.3");
  EXPECT_EQ(FixedText(99.6, 0), "100");
  EXPECT_EQ(FixedText(std::numeric_limits<double>::quiet_NaN(), 2), "nan");
}

TEST(Printable, HasNoControlCharacters) {
  EXPECT_EQ(Printable("a\nb\x1f\x7f c\xc3\xa9"), "a?b?? c\xc3\xa9");
}

}  // namespace
}  // namespace gmapping_spa::backend
