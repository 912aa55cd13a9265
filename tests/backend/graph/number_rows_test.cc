// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/number_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "tests/message_of.h"

namespace gmapping_spa::backend::number_rows_test {
namespace {

using ::testing::ElementsAre;

std::string ErrorOf(const std::string& text) {
  std::istringstream in(text);
  NumberRows rows(in, "file.txt", "a b");
  return MessageOf([&] {
    while (rows.Next()) {
    }
  });
}

TEST(NumberRows, SkipsCommentsAndBlankLinesAndTakesAnyBlanks) {
  std::istringstream in("# a b\n\n1 2\r\n   \n  # note\n\t+3\t -4e-1  \n");
  NumberRows rows(in, "file.txt", "a b");
  ASSERT_TRUE(rows.Next());
  EXPECT_THAT(rows.row(), ElementsAre(1.0, 2.0));
  ASSERT_TRUE(rows.Next());
  EXPECT_THAT(rows.row(), ElementsAre(3.0, -0.4));
  EXPECT_FALSE(rows.Next());
}

TEST(NumberRows, SkipsAByteOrderMarkAndCommentsAfterTheColumns) {
  std::istringstream in(
      "\xef\xbb\xbf"
      "1 2 # first\n3 4# second\n");
  NumberRows rows(in, "file.txt", "a b");
  ASSERT_TRUE(rows.Next());
  EXPECT_THAT(rows.row(), ElementsAre(1.0, 2.0));
  ASSERT_TRUE(rows.Next());
  EXPECT_THAT(rows.row(), ElementsAre(3.0, 4.0));
  EXPECT_EQ(ErrorOf("1 2\n\xef\xbb\xbf"
                    "3 4\n"),
            "file.txt:2: expected a finite number, found '??"
            "?3'");
}

TEST(NumberRows, ReadsALastLineWithoutLineEnd) {
  std::istringstream in("1 2\n3 4");
  NumberRows rows(in, "file.txt", "a b");
  EXPECT_TRUE(rows.Next());
  ASSERT_TRUE(rows.Next());
  EXPECT_THAT(rows.row(), ElementsAre(3.0, 4.0));
}

TEST(NumberRows, ErrorsNameTheLineAndWhatIsThere) {
  EXPECT_EQ(ErrorOf("# comment\n1 2\n1 2 3\n"), "file.txt:3: expected 2 columns (a b), found 3");
  EXPECT_EQ(ErrorOf("1\n"), "file.txt:1: expected 2 columns (a b), found 1");
  EXPECT_EQ(ErrorOf("1 two\n"), "file.txt:1: expected a finite number, found 'two'");
  EXPECT_EQ(ErrorOf("1 2x\n"), "file.txt:1: expected a finite number, found '2x'");
  EXPECT_EQ(ErrorOf("1 +\n"), "file.txt:1: expected a finite number, found '+'");
}

TEST(NumberRows, RejectsWhatIsNotFinite) {
  for (const std::string value : {"nan", "-nan", "inf", "-inf", "1e999"}) {
    EXPECT_EQ(ErrorOf("1 " + value), "file.txt:1: expected a finite number, found '" + value + "'");
  }
}

TEST(NumberRows, ErrorsStayOneShortLineOnBinaryInput) {
  EXPECT_EQ(ErrorOf("1 " + std::string(1000, '\x01')),
            "file.txt:1: expected a finite number, found '" + std::string(40, '?') + "...'");
}

TEST(NumberRows, AStreamThatBreaksIsAnError) {
  std::istringstream in("1 2\n");
  NumberRows rows(in, "file.txt", "a b");
  in.setstate(std::ios::badbit);
  EXPECT_THROW(rows.Next(), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::backend::number_rows_test
