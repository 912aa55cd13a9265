// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/unproven.h"

#include <gtest/gtest.h>

#include <vector>

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

// A robot that drives 200 m straight on, a node every metre.
class Unproven : public testing::Test {
 protected:
  Unproven() {
    for (int k = 0; k <= 200; ++k) {
      poses_.push_back({1.0 * k, 0.0, 0.0});
      ways_m_.push_back(k);
    }
  }

  // A closure that has node 100 + `old_node` `moved_m` before where it is.
  void Add(int old_node, double moved_m, Verdict verdict = Verdict::kUnconfirmed) {
    ClosureRecord record;
    record.old_node = old_node;
    record.node = 100 + old_node;
    record.old_T_node = {100.0 - moved_m, 0.0, 0.0};
    record.verdict = verdict;
    records_.push_back(record);
  }

  void Close(int old_node, int node) {
    backend::Edge& closure = closures_.emplace_back();
    closure.i = old_node;
    closure.j = node;
  }

  std::vector<UnprovenClosure> Find() const {
    return UnprovenClosures({}, {}, {poses_, ways_m_}, closures_, records_);
  }

  std::vector<SE2> poses_;
  std::vector<double> ways_m_;
  std::vector<ClosureRecord> records_;
  std::vector<backend::Edge> closures_;
};

TEST_F(Unproven, AreThoseThatAgreeAndMoveTheMapTheFarthestFirst) {
  Add(10, 4.0);
  Add(13, 4.1, Verdict::kRival);
  const std::vector<UnprovenClosure> found = Find();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].node, 113);
  EXPECT_NEAR(found[0].moved_m, 4.1, 1e-9);
  EXPECT_EQ(found[1].node, 110);
}

TEST_F(Unproven, OneThatNoOtherAgreesWithIsNone) {
  Add(10, 4.0);
  Add(11, 4.0);   // sees the same scans
  Add(60, 4.0);   // too far off to agree
  Add(13, -4.0);  // says something else
  Add(14, 4.0, Verdict::kNoMatch);
  EXPECT_TRUE(Find().empty());
}

TEST_F(Unproven, WhatDriftDoesNotExplainOrWhatMovesLittleIsNone) {
  for (const double moved_m : {0.9, -7.0}) {
    records_.clear();
    Add(10, moved_m);
    Add(13, moved_m);
    EXPECT_TRUE(Find().empty()) << moved_m;
  }
}

TEST_F(Unproven, WhereALoopIsClosedAreNone) {
  Add(10, 4.0);
  Add(13, 4.0);
  Close(122, 150);
  EXPECT_EQ(Find().size(), 1u);
  Close(119, 150);
  EXPECT_TRUE(Find().empty());
}

TEST_F(Unproven, OfAPieceThatIsNotJoinedAreNone) {
  Add(10, 4.0);
  Add(13, 4.0);
  for (int k = 60; k <= 200; ++k) ways_m_[k] += kUnknownWay_m;
  EXPECT_TRUE(Find().empty());
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
