#include "backend/graph/text_line.h"

#include <gtest/gtest.h>

namespace gmapping_spa::backend {
namespace {

TEST(TextLine, AByteOrderMarkIsTakenOffOnceAndAtTheFrontOnly) {
  EXPECT_EQ(WithoutByteOrderMark("\xef\xbb\xbf"
                                 "VERTEX"),
            "VERTEX");
  EXPECT_EQ(WithoutByteOrderMark("VERTEX\xef\xbb\xbf"), "VERTEX\xef\xbb\xbf");
  EXPECT_EQ(WithoutByteOrderMark("\xef\xbb"), "\xef\xbb");
  EXPECT_EQ(WithoutByteOrderMark(""), "");
}

TEST(TextLine, ACommentReachesFromItsSignToTheEnd) {
  EXPECT_EQ(WithoutComment("1 2 3# a # b"), "1 2 3");
  EXPECT_EQ(WithoutComment("# only"), "");
  EXPECT_EQ(WithoutComment("1 2 3"), "1 2 3");
}

TEST(TextLine, WordsAreTakenUntilNoneIsLeft) {
  std::string_view rest = " one\ttwo \r";
  EXPECT_EQ(TakeWord(&rest), "one");
  EXPECT_EQ(TakeWord(&rest), "two");
  EXPECT_EQ(TakeWord(&rest), "");
  EXPECT_EQ(TakeWord(&rest), "");
}

TEST(TextLine, QuotedWordsAreShortAndPrintable) {
  EXPECT_EQ(Quoted("VERTEX_XY"), "'VERTEX_XY'");
  EXPECT_EQ(Quoted("a\x01z"), "'a?z'");
  EXPECT_EQ(Quoted(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace gmapping_spa::backend
