// SPDX-License-Identifier: BSD-3-Clause
// Loop closures that somebody edits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "frontend/loop_closure/loop_closer.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::loop_closure::loop_closer_by_hand_test {
namespace {

using backend::SE2;

// A drive around the Ring and on, nodes every metre, with drift that loop closing takes away.
class EditedClosures : public testing::Test {
 protected:
  EditedClosures() : closer_(LoopCloser::Options()) {
    truth_ = synthetic::DriveOnRing(0, 66, 1.0);
    estimate_ = synthetic::WithDrift(
        truth_, {.scale = 1.01, .rad_per_m = 0.0015, .lateral_per_m = 0.008}, truth_[0]);
    scans_ = synthetic::ScansAt(truth_, synthetic::Ring(), {.usable_range_m = 12.0});
    for (std::size_t k = 1; k <= estimate_.size(); ++k) {
      closer_.Update({estimate_.begin(), estimate_.begin() + static_cast<std::ptrdiff_t>(k)},
                     scan_of_node_);
    }
  }

  static ClosureRecord Rejected(ClosureRecord record) {
    record.overruled_verdict = record.verdict;
    record.verdict = Verdict::kRejected;
    record.is_by_hand = true;
    return record;
  }

  static ClosureRecord Added(int old_node, int node, const SE2& old_T_node) {
    ClosureRecord record;
    record.old_node = old_node;
    record.node = node;
    record.old_T_node = old_T_node;
    record.information = backend::InformationFromSigmas(0.05, 0.02);
    record.source = Source::kHand;
    record.verdict = Verdict::kAccepted;
    record.is_by_hand = true;
    return record;
  }

  static bool Has(const LoopCloser& closer, int old_node, int node) {
    return std::ranges::any_of(closer.closures(), [&](const backend::Edge& closure) {
      return closure.i == old_node && closure.j == node;
    });
  }

  std::vector<SE2> truth_, estimate_;
  std::vector<sensor::LaserScan> scans_;
  ScanOfNode scan_of_node_ = [this](int node) { return scans_.at(node); };
  LoopCloser closer_;
};

TEST_F(EditedClosures, WithoutChangesAreTheSame) {
  const std::vector<backend::Edge> before = closer_.closures();
  ASSERT_GE(before.size(), 2u);
  const std::size_t records = closer_.records().size();
  closer_.Edit(closer_.records());
  EXPECT_EQ(closer_.records().size(), records);
  ASSERT_EQ(closer_.closures().size(), before.size());
  for (const backend::Edge& closure : before) EXPECT_TRUE(Has(closer_, closure.i, closure.j));
}

TEST_F(EditedClosures, RejectedOnesAreNotFoundAgain) {
  std::vector<ClosureRecord> records = closer_.records();
  for (ClosureRecord& record : records) {
    if (record.verdict == Verdict::kAccepted) record = Rejected(record);
  }
  const std::vector<backend::Edge> before = closer_.closures();
  closer_.Edit(records);
  EXPECT_TRUE(closer_.closures().empty());
  closer_.UpdateAll(estimate_, scan_of_node_);
  for (const backend::Edge& closure : before) {
    for (int shift = -1; shift <= 1; ++shift) {
      EXPECT_FALSE(Has(closer_, static_cast<int>(closure.i) + shift, static_cast<int>(closure.j)));
    }
  }
}

TEST_F(EditedClosures, AcceptedOnesThatAreTakenOutOfTheTableAreRejected) {
  const backend::Edge closure = closer_.closures().front();
  std::vector<ClosureRecord> records = closer_.records();
  std::erase_if(records, [&](const ClosureRecord& record) {
    return record.old_node == closure.i && record.node == closure.j;
  });
  closer_.Edit(records);
  EXPECT_FALSE(Has(closer_, static_cast<int>(closure.i), static_cast<int>(closure.j)));
  const auto taken_out = std::ranges::find_if(closer_.records(), &ClosureRecord::is_by_hand);
  ASSERT_NE(taken_out, closer_.records().end());
  EXPECT_EQ(taken_out->verdict, Verdict::kRejected);
  EXPECT_EQ(taken_out->overruled_verdict, Verdict::kAccepted);
}

// Off by 3 m: Review would release it.
TEST_F(EditedClosures, AddedOnesStayHoweverTheyContradictTheGraph) {
  std::vector<ClosureRecord> records = closer_.records();
  records.push_back(Added(4, 30, Between(truth_[4], truth_[30]) * SE2{3.0, 0.0, 0.0}));
  closer_.Edit(records);
  ASSERT_TRUE(Has(closer_, 4, 30));
  EXPECT_EQ(closer_.closures().back().kind, backend::EdgeKind::kScanMatch) << "no loss weighs it";
  EXPECT_EQ(closer_.closures().front().kind, backend::EdgeKind::kLoopClosure);
  const std::size_t count = closer_.closures().size();
  EXPECT_EQ(closer_.Review(truth_), 0) << "nor do others get a wider gate by it";
  EXPECT_EQ(closer_.closures().size(), count);
}

TEST_F(EditedClosures, MeasuresHowTwoNodesLieToEachOther) {
  const ClosureRecord record = closer_.Measure(estimate_, scan_of_node_, 6, 54);
  EXPECT_EQ(record.verdict, Verdict::kUnconfirmed);
  EXPECT_EQ(record.source, Source::kHand);
  const SE2 off = Between(Between(truth_[6], truth_[54]), record.old_T_node);
  EXPECT_LT(off.translation().norm(), 0.05);
  EXPECT_LT(std::abs(off.theta), 0.02);
}

TEST_F(EditedClosures, NodesThatSawNothingInCommonCannotBeMeasured) {
  const ClosureRecord record = closer_.Measure(estimate_, scan_of_node_, 6, 30);
  EXPECT_NE(record.verdict, Verdict::kUnconfirmed);
  EXPECT_NE(record.verdict, Verdict::kRival);
}

}  // namespace
}  // namespace gmapping_spa::loop_closure::loop_closer_by_hand_test
