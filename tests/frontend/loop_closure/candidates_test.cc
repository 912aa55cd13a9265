// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gmapping_spa::loop_closure::candidates_test {
namespace {

using backend::SE2;

// Passes along the x axis from 0 to 30 m, one node a metre, and the way back of 30 m in between
// that leaves no nodes. Pass p lies at y = offsets[p].
std::vector<SE2> Passes(const std::vector<double>& offsets) {
  std::vector<SE2> poses;
  for (const double y : offsets) {
    for (int x = 0; x <= 30; ++x) poses.push_back({1.0 * x, y, 0});
  }
  return poses;
}

// Not the default one, which may be tuned.
constexpr DriftModel kDrift{.floor_m = 0.1, .m_per_m = 0.01, .floor_rad = 0.01, .rad_per_m = 5e-4};

std::vector<Candidate> Find(const CandidateOptions& options, const std::vector<SE2>& poses,
                            int node, const std::vector<backend::Edge>& closures = {}) {
  const std::vector<double> driven = WaysDriven(poses);
  return FindCandidates(options, kDrift, poses, driven, ShortestWays(driven, closures, node), node);
}

TEST(FindCandidates, FindsTheNearestNodeOfAnEarlierPass) {
  const std::vector<Candidate> found = Find({}, Passes({0, 0.5}), 31 + 12);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].old_node, 12);
  EXPECT_NEAR(found[0].distance_m, 0.5, 1e-9);
  EXPECT_NEAR(found[0].path_length_m, 18 + std::hypot(30, 0.5) + 12, 1e-9);
}

TEST(FindCandidates, LeavesOutWhatIsNearOnTheWay) {
  const std::vector<SE2> poses = Passes({0});
  EXPECT_TRUE(Find({}, poses, 30).empty());
  CandidateOptions near;
  near.min_path_length_m = 2.0;
  for (const Candidate& candidate : Find(near, poses, 30)) EXPECT_GE(candidate.path_length_m, 2.0);
  EXPECT_FALSE(Find(near, poses, 30).empty());
}

TEST(FindCandidates, AClosureMakesTheWayShort) {
  const std::vector<SE2> poses = Passes({0, 0.5});
  backend::Edge closure;
  closure.i = 10;
  closure.j = 31 + 10;
  EXPECT_TRUE(Find({}, poses, 31 + 12, {closure}).empty());
}

TEST(FindCandidates, LooksOnlyBack) {
  for (const Candidate& candidate : Find({}, Passes({0, 0.5, 1.0}), 31 + 12)) {
    EXPECT_LT(candidate.old_node, 31 + 12);
  }
}

TEST(FindCandidates, LooksFartherTheLongerTheWay) {
  // The pass before lies 6 m off. 4 m are in sight anyway; on a way of 60 m three standard
  // deviations of drift are 3 * 0.7 m.
  CandidateOptions options;
  EXPECT_EQ(Find(options, Passes({0, 6}), 31 + 15).size(), 1u);
  EXPECT_TRUE(Find(options, Passes({0, 6.6}), 31 + 15).empty());
  options.max_drift_m = 1.0;
  EXPECT_TRUE(Find(options, Passes({0, 6}), 31 + 15).empty());
  options = {};
  options.sigmas = 1.0;
  EXPECT_TRUE(Find(options, Passes({0, 6}), 31 + 15).empty());
}

TEST(FindCandidates, FindsOneOfEachPassTheMostLikelyFirst) {
  const std::vector<Candidate> found = Find({}, Passes({1.0, 3.0, 0.6, 0}), 3 * 31 + 15);
  ASSERT_EQ(found.size(), 3u);
  // The second pass is 3 m away; the first one is nearer in terms of the longer way since, though
  // not than the third one.
  EXPECT_EQ(found[0].old_node, 2 * 31 + 15);
  EXPECT_EQ(found[1].old_node, 15);
  EXPECT_EQ(found[2].old_node, 31 + 15);
}

TEST(FindCandidates, TheWayCountsForWhatIsLikely) {
  // Two passes equally far off: after the longer way it is the more likely one.
  const std::vector<Candidate> found =
      Find({.max_candidates = 2}, Passes({1.0, -1.0, 0}), 2 * 31 + 15);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].old_node, 15);
  EXPECT_EQ(found[1].old_node, 31 + 15);
}

TEST(FindCandidates, FindsNoMoreThanTheMaximum) {
  const std::vector<SE2> poses = Passes({1.0, 0.8, 0.6, 0.4, 0.2, 0});
  for (const int maximum : {0, 1, 2, 4}) {
    CandidateOptions options;
    options.max_candidates = maximum;
    EXPECT_EQ(Find(options, poses, 5 * 31 + 15).size(), static_cast<std::size_t>(maximum));
  }
}

}  // namespace
}  // namespace gmapping_spa::loop_closure::candidates_test
