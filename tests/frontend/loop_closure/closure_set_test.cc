// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/closure_set.h"

#include <gtest/gtest.h>

#include <vector>

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

// A robot that drives 200 m straight on, a node every metre; it believes to be elsewhere than where
// it was when closures say that node 100 + k is at node k.
class ClosureSets : public testing::Test {
 protected:
  ClosureSets() {
    for (int k = 0; k <= 200; ++k) {
      poses_.push_back({1.0 * k, 0.0, 0.0});
      ways_m_.push_back(k);
    }
  }

  // Closures every 2 m from node 110 + `from` on, `off_m` beside the old node, with that gate.
  ClosureSet Closures(int count, double gate, double off_m = 0.0, int from = 0) {
    ClosureSet set;
    for (int k = 0; k < count; ++k) {
      ClosureRecord record;
      record.old_node = 10 + from + 2 * k;
      record.node = 110 + from + 2 * k;
      record.old_T_node = {0.0, off_m, 0.0};
      record.mahalanobis_sq = gate;
      records_.push_back(record);
      set.members.push_back(records_.size() - 1);
    }
    set.first_node = 110 + from;
    set.last_node = 110 + from + 2 * (count - 1);
    return set;
  }

  std::size_t Proven(const ClosureSet& set) const {
    return ProvenSets(options_, {}, path_, records_, {set})[0].size();
  }

  std::vector<SE2> poses_;
  std::vector<double> ways_m_;
  std::vector<ClosureRecord> records_;
  DrivenPath path_{poses_, ways_m_};
  ProofOptions options_{
      .min_members = 4, .min_span_m = 12.0, .max_mahalanobis_sq = 10.0, .min_per_contradiction = 3};
};

TEST_F(ClosureSets, AreProvenByEnoughMembersOverEnoughDriving) {
  EXPECT_EQ(Proven(Closures(7, 5.0)), 7u);  // 12 m
  EXPECT_EQ(Proven(Closures(6, 5.0)), 0u);
  options_.min_members = 8;
  EXPECT_EQ(Proven(Closures(7, 5.0)), 0u);
}

TEST_F(ClosureSets, NeedMoreDrivingTheFartherOffTheyAre) {
  EXPECT_EQ(Proven(Closures(12, 40.0)), 0u);  // 22 m of 24 m
  EXPECT_EQ(Proven(Closures(13, 40.0)), 13u);
  EXPECT_EQ(Proven(Closures(13, 1000.0)), 0u);
}

TEST_F(ClosureSets, AreLessOfAProofTheFartherOffTheyAre) {
  const auto proof = [this](const ClosureSet& set) {
    return ProofOf(options_, path_, records_, set.members);
  };
  EXPECT_DOUBLE_EQ(proof(Closures(7, 5.0)), 1.0);  // 12 m
  EXPECT_DOUBLE_EQ(proof(Closures(7, 40.0)), 0.5);
  EXPECT_DOUBLE_EQ(proof(Closures(13, 40.0)), 1.0);
  EXPECT_DOUBLE_EQ(proof({}), 0.0);
}

TEST_F(ClosureSets, ThatAgreeProveEachOther) {
  const auto proven = [this](const std::vector<ClosureSet>& sets) {
    return ProvenSets(options_, {}, path_, records_, sets)[0].size();
  };
  const ClosureSet first = Closures(6, 5.0);  // 10 m
  const ClosureSet later = Closures(5, 5.0, 0.0, 40);
  EXPECT_EQ(proven({first}), 0u);
  EXPECT_EQ(proven({first, later}), 6u);
  EXPECT_EQ(proven({first, first}), 0u) << "the same driving";
  EXPECT_EQ(proven({first, Closures(5, 5.0, 3.0, 40)}), 0u) << "not the same way off";
  EXPECT_EQ(proven({first, Closures(5, 5.0, 1.4, 40)}), 6u) << "within two standard deviations";
  EXPECT_EQ(proven({first, Closures(3, 5.0, 0.0, 40)}), 0u) << "no set of its own";
  options_.agree_within_m = 50.0;
  EXPECT_EQ(proven({first, later}), 0u) << "too far away";
}

TEST_F(ClosureSets, FallWithTheirContradictions) {
  ClosureSet set = Closures(9, 5.0);
  set.contradictions = 3;
  EXPECT_EQ(Proven(set), 9u);
  set.contradictions = 4;
  EXPECT_EQ(Proven(set), 0u);
}

TEST_F(ClosureSets, LeaveOutMembersThatDoNotGoWithTheOthers) {
  const ClosureSet set = Closures(9, 5.0);
  records_[set.members[4]].old_T_node = {3.0, 1.0, 0.8};
  const std::vector<std::size_t> proven = ProvenSets(options_, {}, path_, records_, {set})[0];
  EXPECT_EQ(proven.size(), 8u);
  for (const std::size_t member : proven) EXPECT_NE(member, set.members[4]);
}

TEST_F(ClosureSets, ContradictOthersOfTheSameStretchOnly) {
  const ClosureSet set = Closures(7, 5.0), same = Closures(7, 5.0, 0.2);
  EXPECT_FALSE(Contradict(options_, path_, records_, set, same));
  ClosureSet other = Closures(7, 5.0, 4.0);
  EXPECT_TRUE(Contradict(options_, path_, records_, set, other));
  EXPECT_TRUE(Contradict(options_, path_, records_, other, set));
  other.first_node = 150;
  other.last_node = 170;
  EXPECT_FALSE(Contradict(options_, path_, records_, set, other));
}

// In twin corridors each closure has a twin, a corridor's width off; the estimate tells them apart.
TEST_F(ClosureSets, WhatDriftExplainsFarMoreEasilyIsLikelier) {
  const auto has_rival = [this](double rival_mahalanobis_sq, double off_m, int nodes_on,
                                Verdict verdict, Source source) {
    records_.clear();
    Closures(1, 11.0, 7.0);
    records_[0].verdict = Verdict::kUnconfirmed;
    Closures(1, rival_mahalanobis_sq, off_m, nodes_on);
    records_[1].verdict = verdict;
    records_[1].source = source;
    return HasLikelierRival(options_, path_, records_, records_[0]);
  };
  EXPECT_TRUE(has_rival(0.5, 0.0, 4, Verdict::kUnconfirmed, Source::kNear));
  EXPECT_TRUE(has_rival(0.5, 0.0, 4, Verdict::kAccepted, Source::kNear));
  EXPECT_FALSE(has_rival(0.5, 7.0, 4, Verdict::kAccepted, Source::kNear)) << "says the same";
  EXPECT_FALSE(has_rival(9.0, 0.0, 4, Verdict::kAccepted, Source::kNear)) << "hardly likelier";
  EXPECT_FALSE(has_rival(0.5, 0.0, 40, Verdict::kAccepted, Source::kNear)) << "far away";
  EXPECT_FALSE(has_rival(0.5, 0.0, 4, Verdict::kOverlap, Source::kNear)) << "refused";
  EXPECT_FALSE(has_rival(0.5, 0.0, 4, Verdict::kUnconfirmed, Source::kPlace)) << "a guess";
}

TEST_F(ClosureSets, PredictWhereANodeWouldBe) {
  const ClosureSet set = Closures(7, 5.0, 0.5);
  const ClosureRecord& nearest = NearestMember(path_, records_, set, 115);
  EXPECT_EQ(nearest.node, 114);
  const SE2 predicted = PredictedPose(path_, nearest, 115);
  EXPECT_NEAR(predicted.x, 15.0, 1e-9);
  EXPECT_NEAR(predicted.y, 0.5, 1e-9);
  EXPECT_EQ(SpanOf(path_, records_, set.members), 12.0);
  EXPECT_EQ(SpanOf(path_, records_, {}), 0.0);
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
