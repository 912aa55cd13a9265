// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/closure_table.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

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

TEST(WriteClosures, TellsWhatWasFoundFromWhatSomebodyDecided) {
  ClosureRecord overruled, added;
  overruled.is_by_hand = added.is_by_hand = true;
  overruled.verdict = Verdict::kRejected;
  overruled.overruled_verdict = added.verdict = Verdict::kAccepted;
  added.source = loop_closure::Source::kHand;
  std::ostringstream out;
  WriteClosures({overruled, added}, Nodes(1), out);
  EXPECT_NE(out.str().find(",near,accepted,rejected\n"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find(",hand,,accepted\n"), std::string::npos) << out.str();
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
  record.information.diagonal() << 100, 200, 0.1;
  record.verdict = Verdict::kAccepted;
  ClosureRecord refused;
  refused.node = 3;
  refused.verdict = Verdict::kOverlap;
  std::ostringstream out;
  WriteClosures({record, refused}, Nodes(5), out);
  EXPECT_EQ(out.str(),
            "old_node,node,old_stamp_s,stamp_s,path_length_m,distance_m,score,runner_up_score,"
            "overlap,inlier_ratio,"
            "mutual_inlier_ratio,mahalanobis_sq,x_m,y_m,theta_rad,I11,I12,I13,I22,I23,I33,source,"
            "found,verdict\n"
            "1,4,1000000000.500000,1000000002.000000,48.250,1.500,0.750,0.500,0.625,0.875,0.750,"
            "2.250,-1.25,0.5,0.0625,100,0,0,200,0,0.1,followed,accepted,accepted\n"
            "0,3,1000000000.000000,1000000001.500000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,"
            "0.000,0,0,0,0,0,0,0,0,0,near,overlap,overlap\n");
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
