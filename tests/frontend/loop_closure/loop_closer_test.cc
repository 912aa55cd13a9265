// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/loop_closer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

class LoopClosing : public testing::Test {
 protected:
  // With numbers on which the tests rely: the defaults may be tuned.
  static LoopCloser::Options Options() {
    LoopCloser::Options options;
    options.confirm_sigmas = 1.5;
    options.drift = {.floor_m = 0.1, .m_per_m = 0.01, .floor_rad = 0.01, .rad_per_m = 0.0005};
    return options;
  }

  // Nodes every metre on the Ring, the path estimated with `drift`.
  void Drive(double to_m, const synthetic::Drift& drift) {
    truth_ = synthetic::DriveOnRing(0, to_m, 1.0);
    estimate_ = synthetic::WithDrift(truth_, drift, truth_[0]);
    scans_ = synthetic::ScansAt(truth_, synthetic::Ring(), {.usable_range_m = 12.0});
  }

  // The path up to so many metres, as the closer sees it on the way.
  std::vector<SE2> PathUpTo(int path_length_m) const {
    return {estimate_.begin(), estimate_.begin() + path_length_m + 1};
  }

  int UpdateAt(int path_length_m, LoopCloser* closer) const {
    return closer->Update(PathUpTo(path_length_m), scan_of_node_);
  }

  // As in a run: with every node. Returns the number of accepted closures.
  int UpdateWithEveryNode(LoopCloser* closer) const {
    int accepted = 0;
    for (int k = 0; k < static_cast<int>(estimate_.size()); ++k) accepted += UpdateAt(k, closer);
    return accepted;
  }

  void ExpectRight(const std::vector<backend::Edge>& closures) const {
    for (const backend::Edge& closure : closures) {
      EXPECT_EQ(closure.kind, backend::EdgeKind::kLoopClosure);
      const SE2 truth = Between(truth_.at(closure.i), truth_.at(closure.j));
      const SE2 off = Between(truth, closure.i_T_j);
      EXPECT_LT(off.translation().norm(), 0.05) << closure.i << ' ' << closure.j;
      EXPECT_LT(std::abs(off.theta), 0.02) << closure.i << ' ' << closure.j;
    }
  }

  std::vector<SE2> truth_, estimate_;
  std::vector<sensor::LaserScan> scans_;
  ScanOfNode scan_of_node_ = [this](int node) { return scans_.at(node); };
};

constexpr synthetic::Drift kDrift{.scale = 1.01, .rad_per_m = 0.0015, .lateral_per_m = 0.008};

TEST_F(LoopClosing, ClosesALoopWithClosuresThatAgree) {
  Drive(66, kDrift);
  const SE2 off = Between(Between(truth_[4], truth_[52]), Between(estimate_[4], estimate_[52]));
  ASSERT_GT(off.translation().norm(), 0.3) << "there is something to find";
  LoopCloser closer(Options());
  const int accepted = UpdateWithEveryNode(&closer);
  EXPECT_GE(accepted, 2);
  EXPECT_EQ(closer.closures().size(), static_cast<std::size_t>(accepted));
  ExpectRight(closer.closures());
}

TEST_F(LoopClosing, EveryCandidateHasARecordAndAcceptedOnesAreTheClosures) {
  Drive(66, kDrift);
  LoopCloser closer(Options());
  UpdateWithEveryNode(&closer);
  std::set<std::pair<std::int64_t, std::int64_t>> accepted, closures;
  for (const ClosureRecord& record : closer.records()) {
    EXPECT_STRNE(VerdictName(record.verdict), "unknown");
    EXPECT_LT(record.old_node, record.node);
    if (record.verdict == Verdict::kAccepted) accepted.emplace(record.old_node, record.node);
  }
  for (const backend::Edge& closure : closer.closures()) closures.emplace(closure.i, closure.j);
  EXPECT_EQ(accepted, closures);
  EXPECT_GE(closer.records().size(), accepted.size());
}

TEST_F(LoopClosing, FindsNothingOnAPathWithoutRevisits) {
  Drive(40, kDrift);
  LoopCloser closer(Options());
  EXPECT_EQ(UpdateWithEveryNode(&closer), 0);
  EXPECT_EQ(closer.UpdateAll(estimate_, scan_of_node_), 0);
  EXPECT_TRUE(closer.closures().empty());
}

TEST_F(LoopClosing, ASingleClosureStaysUnconfirmed) {
  Drive(66, kDrift);
  LoopCloser closer(Options());
  EXPECT_EQ(UpdateAt(60, &closer), 0);
  ASSERT_EQ(closer.records().size(), 1u);
  EXPECT_EQ(closer.records()[0].verdict, Verdict::kUnconfirmed);
  EXPECT_TRUE(closer.closures().empty());

  // A second one that agrees confirms both.
  EXPECT_EQ(UpdateAt(66, &closer), 2);
  EXPECT_EQ(closer.records()[0].verdict, Verdict::kAccepted);
  ExpectRight(closer.closures());
}

TEST_F(LoopClosing, WhatWasFoundInALargeWindowIsConfirmedFromFartherApart) {
  Drive(68, kDrift);
  LoopCloser::Options options = Options();
  options.drift.m_per_m = 0.06;  // the window reaches 9 m and more
  options.search_everywhere = false;
  LoopCloser closer(options);
  for (const int path_length_m : {60, 62, 64})
    EXPECT_EQ(UpdateAt(path_length_m, &closer), 0) << path_length_m;
  const auto found = [&] {
    int count = 0;
    for (const ClosureRecord& record : closer.records()) {
      count += record.verdict == Verdict::kUnconfirmed ? 1 : 0;
    }
    return count;
  };
  ASSERT_GE(found(), 2) << "that agree, but show the same";
  int accepted = 0;
  for (const int path_length_m : {66, 68}) accepted += UpdateAt(path_length_m, &closer);
  EXPECT_GE(accepted, 2);
}

TEST_F(LoopClosing, ASecondLookAtTheSamePlaceConfirmsNothing) {
  Drive(66, kDrift);
  LoopCloser::Options options = Options();
  options.confirm_beyond_m = 7.0;  // the two looks are 6 m apart
  LoopCloser closer(options);
  EXPECT_EQ(UpdateAt(60, &closer), 0);
  EXPECT_EQ(UpdateAt(66, &closer), 0);
  ASSERT_EQ(closer.records().size(), 2u);
  EXPECT_EQ(closer.records()[1].verdict, Verdict::kUnconfirmed);
}

TEST_F(LoopClosing, ClosuresTooFarApartDoNotConfirmEachOther) {
  Drive(66, kDrift);
  LoopCloser::Options options = Options();
  options.confirm_within_m = 4.0;
  LoopCloser closer(options);
  EXPECT_EQ(UpdateAt(60, &closer), 0);
  EXPECT_EQ(UpdateAt(66, &closer), 0);
  EXPECT_EQ(closer.records().size(), 2u);
}

TEST_F(LoopClosing, ClosuresThatContradictEachOtherAreNotAccepted) {
  // Between two closures the robot is carried away by 0.85 m, which the estimate knows nothing of:
  // what they say does not go together, though each of them may be right.
  Drive(78, {});
  for (std::size_t k = 62; k < estimate_.size(); ++k) {
    estimate_[k] = SE2{-0.6, 0.6, 0} * estimate_[k];
  }
  LoopCloser closer(Options());
  EXPECT_EQ(UpdateAt(61, &closer), 0);  // looks at the node at 56 m
  EXPECT_EQ(UpdateAt(76, &closer), 0);  // at 71 m
  ASSERT_EQ(closer.records().size(), 2u);
  for (const ClosureRecord& record : closer.records()) {
    EXPECT_EQ(record.verdict, Verdict::kUnconfirmed) << VerdictName(record.verdict);
  }
  EXPECT_TRUE(closer.closures().empty());
}

TEST_F(LoopClosing, LooksAtANodeAfterEachStretchOfTheWay) {
  Drive(66, {});
  LoopCloser::Options options = Options();
  options.search_every_m = 6.0;
  options.candidates.min_path_length_m = 40.0;  // of one pass only
  LoopCloser closer(options);
  UpdateWithEveryNode(&closer);
  std::vector<int> nodes;
  for (const ClosureRecord& record : closer.records()) nodes.push_back(record.node);
  ASSERT_GE(nodes.size(), 3u);
  for (std::size_t k = 1; k < nodes.size(); ++k) EXPECT_NEAR(nodes[k] - nodes[k - 1], 6, 1);
  EXPECT_LE(nodes.back(), 61) << "what lies ahead is part of what is matched";
}

TEST_F(LoopClosing, UpdateAllFindsWhatTheDriveHadNoTimeFor) {
  Drive(60, kDrift);
  LoopCloser closer(Options());
  EXPECT_GE(closer.UpdateAll(estimate_, scan_of_node_), 2);
  ExpectRight(closer.closures());
  const std::size_t closures = closer.closures().size();
  EXPECT_EQ(closer.UpdateAll(estimate_, scan_of_node_), 0) << "all of them are known by now";
  EXPECT_EQ(closer.closures().size(), closures);
}

TEST_F(LoopClosing, APlaceThatIsLookedAtAgainIsClosedOnce) {
  Drive(66, kDrift);
  LoopCloser closer(Options());
  UpdateAt(60, &closer);  // unconfirmed
  closer.UpdateAll(estimate_, scan_of_node_);
  std::set<std::pair<std::int64_t, std::int64_t>> closures;
  for (const backend::Edge& closure : closer.closures()) {
    EXPECT_TRUE(closures.emplace(closure.i, closure.j).second) << closure.i << ' ' << closure.j;
  }
  EXPECT_GE(closures.size(), 2u);
}

TEST_F(LoopClosing, ReleasesWhatTheGraphContradictsAndTakesItBack) {
  Drive(66, kDrift);
  LoopCloser closer(Options());
  const int accepted = UpdateWithEveryNode(&closer);
  ASSERT_GE(accepted, 2);
  EXPECT_EQ(closer.Review(truth_), 0) << "all of them are right";

  // As optimized by something that knows that one of them is wrong, by 2 m.
  std::vector<SE2> elsewhere = truth_;
  const std::int64_t node = closer.closures().back().j;
  elsewhere[node].y += 2.0;
  EXPECT_EQ(closer.Review(elsewhere), 1);
  EXPECT_EQ(closer.closures().size(), static_cast<std::size_t>(accepted) - 1);
  int released = 0;
  for (const ClosureRecord& record : closer.records()) {
    if (record.verdict != Verdict::kReleased) continue;
    ++released;
    EXPECT_EQ(record.node, node);
  }
  EXPECT_EQ(released, 1);
  EXPECT_EQ(closer.Review(elsewhere), 0);

  EXPECT_EQ(closer.Review(truth_), 1);
  EXPECT_EQ(closer.closures().size(), static_cast<std::size_t>(accepted));
}

TEST_F(LoopClosing, ReleasesTheWorstFirst) {
  Drive(66, kDrift);
  LoopCloser closer(Options());
  ASSERT_GE(UpdateWithEveryNode(&closer), 2);
  // What is bent by a wrong closure may be right: only the wrong one goes.
  std::vector<SE2> elsewhere = truth_;
  elsewhere[closer.closures().front().j].y += 5.0;
  elsewhere[closer.closures().back().j].y += 1.0;
  EXPECT_EQ(closer.Review(elsewhere), 1);
  EXPECT_EQ(closer.Review(elsewhere), 1) << "the next one, unless it fits by now";
}

TEST_F(LoopClosing, PathOfOneNodeIsNoLoop) {
  Drive(0, {});
  LoopCloser closer(Options());
  EXPECT_EQ(UpdateAt(0, &closer), 0);
  EXPECT_EQ(closer.UpdateAll(estimate_, scan_of_node_), 0);
  EXPECT_TRUE(closer.records().empty());
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
