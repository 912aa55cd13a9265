// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/closure_table.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/message_of.h"

namespace gmapping_spa::apps {
namespace {

using loop_closure::ClosureRecord;
using loop_closure::Verdict;

std::vector<backend::Node> Nodes(int count) {
  std::vector<backend::Node> nodes;
  for (int k = 0; k < count; ++k)
    nodes.push_back({.id = k, .stamp_s = 1e9 + 0.5 * k, .world_T_node = {}});
  return nodes;
}

std::vector<ClosureRecord> RecordsOf(const std::vector<Verdict>& verdicts) {
  std::vector<ClosureRecord> records;
  for (const Verdict verdict : verdicts) {
    records.emplace_back();
    records.back().verdict = verdict;
  }
  return records;
}

TEST(WriteClosures, WritesALineForEachCandidate) {
  ClosureRecord record;
  record.old_node = 1;
  record.node = 4;
  record.path_length_m = 48.25;
  record.distance_m = 1.5;
  record.score = 0.75;
  record.runner_up_score = 0.5;
  record.overlap = 0.625;
  record.inlier_ratio = 0.875;
  record.mutual_inlier_ratio = 0.75;
  record.mahalanobis_sq = 2.25;
  record.old_T_node = {-1.25, 0.5, 0.0625};
  record.source = loop_closure::Source::kFollowed;
  record.verdict = Verdict::kAccepted;
  ClosureRecord refused;
  refused.node = 3;
  refused.verdict = Verdict::kOverlap;
  std::ostringstream out;
  WriteClosures({record, refused}, Nodes(5), out);
  EXPECT_EQ(out.str(),
            "old_node,node,old_stamp_s,stamp_s,path_length_m,distance_m,score,runner_up_score,"
            "overlap,inlier_ratio,"
            "mutual_inlier_ratio,mahalanobis_sq,x_m,y_m,theta_rad,source,verdict\n"
            "1,4,1000000000.500000,1000000002.000000,48.250,1.500,0.750,0.500,0.625,0.875,0.750,"
            "2.250,-1.2500,0.5000,0.0625,followed,accepted\n"
            "0,3,1000000000.000000,1000000001.500000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,"
            "0.000,0.0000,0.0000,0.0000,near,overlap\n");
}

TEST(WriteClosures, WritesTheHeaderAloneWithoutCandidates) {
  std::ostringstream out;
  WriteClosures({}, {}, out);
  EXPECT_EQ(out.str().find('\n'), out.str().size() - 1);
}

TEST(WriteClosures, NeedsTheNodes) {
  ClosureRecord record;
  record.node = 5;
  std::ostringstream out;
  EXPECT_THROW(WriteClosures({record}, Nodes(5), out), std::out_of_range);
}

std::string MessageOfReading(const std::string& text) {
  std::istringstream in(text);
  return MessageOf([&] { ReadClosures(in, "table", 5); });
}

TEST(ReadClosures, GivesBackWhatWasWritten) {
  ClosureRecord record;
  record.old_node = 1;
  record.node = 4;
  record.path_length_m = 48.25;
  record.mahalanobis_sq = 2.25;
  record.old_T_node = {-1.25, 0.5, 0.0625};
  record.source = loop_closure::Source::kFollowed;
  record.verdict = Verdict::kRival;
  std::stringstream table;
  WriteClosures({record, ClosureRecord{}}, Nodes(5), table);
  const std::vector<ClosureRecord> read = ReadClosures(table, "table", 5);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].old_node, 1);
  EXPECT_EQ(read[0].node, 4);
  EXPECT_EQ(read[0].path_length_m, 48.25);
  EXPECT_EQ(read[0].mahalanobis_sq, 2.25);
  EXPECT_EQ(read[0].old_T_node, record.old_T_node);
  EXPECT_EQ(read[0].source, loop_closure::Source::kFollowed);
  EXPECT_EQ(read[0].verdict, Verdict::kRival);
  EXPECT_EQ(read[1].verdict, Verdict::kNoMatch);
}

TEST(ReadClosures, SaysWhereATableIsBroken) {
  std::ostringstream header;
  WriteClosures({}, {}, header);
  const std::string begin = header.str() + "0,1,";
  EXPECT_EQ(MessageOfReading("x\n"), "table:1: expected the header of loop closures, found 'x'");
  EXPECT_EQ(MessageOfReading(header.str() + "0,5,"), "table:2: expected a node, found '5'");
  EXPECT_EQ(MessageOfReading(begin + "0,0,y"), "table:2: expected a number, found 'y'");
  EXPECT_EQ(MessageOfReading(begin + "0,0,0,0,0,0,0,0,0,0,0,0,0,near,maybe"),
            "table:2: expected a source and a verdict, found 'maybe'");
  EXPECT_EQ(MessageOfReading(begin), "table:2: expected a number, found ''");
}

TEST(CountClosures, CountsByWhatBecameOfThem) {
  Json expected;
  expected["candidates"] = 6;
  expected["accepted"] = 2;
  expected["rejected"]["overlap"] = 3;
  expected["rejected"]["ambiguous"] = 1;
  EXPECT_EQ(CountClosures(RecordsOf({Verdict::kAccepted, Verdict::kOverlap, Verdict::kAccepted,
                                     Verdict::kAmbiguous, Verdict::kOverlap, Verdict::kOverlap})),
            expected);
}

TEST(CountClosures, WithoutCandidatesAreZero) {
  const Json counts = CountClosures({});
  EXPECT_EQ(counts["candidates"], 0);
  EXPECT_EQ(counts["accepted"], 0);
  EXPECT_EQ(counts["rejected"], Json::object());
}

}  // namespace
}  // namespace gmapping_spa::apps
