// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/closure_rows.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "experiments/apps/closure_table.h"
#include "tests/message_of.h"

namespace gmapping_spa::apps::closure_rows_test {
namespace {

using Change = ClosureRow::Change;
using loop_closure::ClosureRecord;
using loop_closure::Source;
using loop_closure::Verdict;

std::vector<ClosureRow> Read(const std::string& text) {
  std::istringstream in(text);
  return ReadClosureRows(in, "closures.csv", 10);
}

ClosureRow ReadOne(const std::string& line) {
  return Read("old_node,node,x_m,y_m,theta_rad,source,found,verdict\n" + line + "\n").at(0);
}

std::string ErrorOf(const std::string& text) {
  return MessageOf([&] { Read(text); });
}

std::string ErrorOfLine(const std::string& line) {
  return MessageOf([&] { ReadOne(line); });
}

TEST(ClosureRows, WhatWasWrittenIsReadBackWithAllDigits) {
  ClosureRecord record;
  record.old_node = 2;
  record.node = 9;
  record.old_T_node = {1.0 / 3.0, -1e-7, 0.1};
  record.information << 3, 0.1, 0.2, 0.1, 4, 1.0 / 7.0, 0.2, 1.0 / 7.0, 5;
  record.source = Source::kFollowed;
  record.verdict = Verdict::kAccepted;
  std::ostringstream out;
  WriteClosures({record}, std::vector<backend::Node>(10), out);
  const std::vector<ClosureRow> rows = Read(out.str());
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].line, 2);
  EXPECT_EQ(rows[0].change, Change::kNone);
  EXPECT_EQ(rows[0].record.old_node, 2);
  EXPECT_EQ(rows[0].record.node, 9);
  EXPECT_EQ(rows[0].record.old_T_node, record.old_T_node);
  EXPECT_EQ(rows[0].record.information, record.information);
  EXPECT_EQ(rows[0].record.source, Source::kFollowed);
  EXPECT_FALSE(rows[0].record.is_by_hand);
}

TEST(ClosureRows, ChangesAreThoseAgainstWhatWasFound) {
  EXPECT_EQ(ReadOne("1,5,1,2,0,near,overlap,overlap").change, Change::kNone);
  const ClosureRow accepted = ReadOne("1,5,1,2,0,near,overlap,accepted");
  EXPECT_EQ(accepted.change, Change::kAccepted);
  EXPECT_TRUE(accepted.record.is_by_hand);
  EXPECT_EQ(accepted.record.overruled_verdict, Verdict::kOverlap);
  const ClosureRow rejected = ReadOne("1,5,1,2,0,near,accepted,reject");
  EXPECT_EQ(rejected.change, Change::kRejected);
  EXPECT_EQ(rejected.record.verdict, Verdict::kRejected);
  EXPECT_EQ(rejected.record.source, Source::kNear);
}

TEST(ClosureRows, RowsOfWhichNothingWasFoundAreAdded) {
  for (const char* line : {"1,5,,,,,,add", "1,5,,,,,,accepted", "1,5,,,,hand,,accept"}) {
    const ClosureRow row = ReadOne(line);
    EXPECT_EQ(row.change, Change::kAdded) << line;
    EXPECT_EQ(row.record.source, Source::kHand) << line;
    EXPECT_TRUE(row.record.is_by_hand) << line;
    EXPECT_FALSE(row.has_pose) << line;
  }
  EXPECT_TRUE(ReadOne("1,5,1,2,0.5,,,add").has_pose);
}

TEST(ClosureRows, TakesWhatSpreadsheetsMakeOfATable) {
  const std::vector<ClosureRow> rows = Read(
      "\xef\xbb\xbfverdict, node ,old_node,note\r\n\r\nadd,5,1,over there\r\n,,,\r\nadd,6,1\r\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].line, 3);
  EXPECT_EQ(rows[1].record.node, 6);
}

TEST(ClosureRows, BadNodesAreNamedWithTheirLine) {
  const std::string expected = "closures.csv:2: expected a node from 0 to 9 as node, found ";
  EXPECT_EQ(ErrorOfLine("1,10,,,,,,add"), expected + "'10'");
  EXPECT_EQ(ErrorOfLine("1,,,,,,,add"), expected + "''");
  EXPECT_EQ(ErrorOfLine("1,2.5,,,,,,add"), expected + "'2.5'");
  const std::string order =
      "closures.csv:2: expected the older node, with the smaller number, as old_node, found ";
  EXPECT_EQ(ErrorOfLine("5,1,,,,,,add"), order + "5 and 1");
  EXPECT_EQ(ErrorOfLine("5,5,,,,,,add"), order + "5 and 5");
  EXPECT_EQ(ErrorOf("old_node,node,verdict\n1,5,add\n1,6,add\n1,5,add\n"),
            "closures.csv:4: expected one accepted closure of nodes 1 and 5, found that of line 2 "
            "as well");
  EXPECT_EQ(Read("old_node,node,found,verdict\n1,5,,add\n1,5,overlap,overlap\n").size(), 2u);
}

TEST(ClosureRows, BadNumbersAreNamedWithTheirLine) {
  EXPECT_EQ(ErrorOfLine("1,5,nan,2,0,,,add"),
            "closures.csv:2: expected a finite number as x_m, found 'nan'");
  EXPECT_EQ(ErrorOfLine("1,5,1,2,,,,add"),
            "closures.csv:2: expected a finite number as theta_rad, found ''");
  EXPECT_EQ(ErrorOfLine("1,5,1,2,east,,,add"),
            "closures.csv:2: expected a finite number as theta_rad, found 'east'");
  EXPECT_EQ(ErrorOfLine("1,5,,,,near,overlap,accepted"),
            "closures.csv:2: expected the pose of an accepted closure as x_m, y_m, theta_rad, "
            "found none");
  const std::string header = "old_node,node,x_m,y_m,theta_rad,I11,I12,I13,I22,I23,I33,verdict\n";
  EXPECT_EQ(ErrorOf(header + "1,5,0,0,0,1,0,0,-1,0,1,add\n"),
            "closures.csv:2: expected a positive definite information matrix as I11 ... I33, found "
            "one that is none");
  EXPECT_TRUE(Read(header + "1,5,0,0,0,,,,,,,add\n").at(0).has_pose);
}

TEST(ClosureRows, BadWordsAreNamedWithTheirLine) {
  const std::string expected =
      "closures.csv:2: expected accepted, rejected, add, or what was found, as verdict, found ";
  EXPECT_EQ(ErrorOfLine("1,5,1,2,0,near,overlap,accpeted"), expected + "'accpeted'");
  EXPECT_EQ(ErrorOfLine("1,5,1,2,0,near,overlap,released"), expected + "'released'");
  EXPECT_EQ(ErrorOfLine("1,5,1,2,0,near,,"), expected + "''");
  EXPECT_EQ(ErrorOfLine("1,5,1,2,0,near,nothing,accepted"),
            "closures.csv:2: expected what the program found as found, found 'nothing'");
}

TEST(ClosureRows, ATableWithoutItsColumnsIsRefused) {
  const std::string expected =
      "expected a first line that names the columns, separated by commas: old_node, node, verdict, "
      "..., found ";
  EXPECT_EQ(ErrorOf(""), "closures.csv: " + expected + "nothing");
  EXPECT_EQ(ErrorOf("old_node;node;verdict\n"), "closures.csv:1: " + expected + "no old_node");
  EXPECT_EQ(ErrorOf("node,node\n"),
            "closures.csv:1: expected a name for one column, found 'node' twice");
  EXPECT_EQ(ErrorOf("old_node,node,verdict\n1,5,add,,\n"),
            "closures.csv:2: expected 3 columns, found 5");
}

}  // namespace
}  // namespace gmapping_spa::apps::closure_rows_test
