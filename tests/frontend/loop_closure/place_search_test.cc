// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/place_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "frontend/loop_closure/drift.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

class PlaceSearching : public testing::Test {
 protected:
  // Places every 4 m of driving.
  void Drive(const std::vector<SE2>& poses, const synthetic::Walls& walls) {
    truth_ = poses;
    scans_ = synthetic::ScansAt(poses, walls, {.usable_range_m = 12.0});
    ways_driven_m_ = WaysDriven(poses);
    for (int node = 0; node < static_cast<int>(poses.size()); node += 4) {
      search_.Add(
          truth_, [this](int k) { return scans_.at(k); }, node);
    }
  }

  std::vector<PlaceMatch> FindLast(double beyond_m) const {
    const int place = search_.size() - 1;
    return search_.Find(place, ways_driven_m_, [&](int old) {
      return ways_driven_m_[search_.NodeOf(place)] - ways_driven_m_[old] > beyond_m;
    });
  }

  PlaceSearch search_{PlaceSearch::Options{}};
  std::vector<SE2> truth_;
  std::vector<sensor::LaserScan> scans_;
  std::vector<double> ways_driven_m_;
};

TEST_F(PlaceSearching, FindsAPlaceAgainAndHowItLies) {
  Drive(synthetic::DriveOnRing(0, 60, 1.0), synthetic::Ring());
  const std::vector<PlaceMatch> matches = FindLast(20.0);
  ASSERT_FALSE(matches.empty());
  int right = 0;
  for (const PlaceMatch& match : matches) {
    const SE2 off = Between(Between(truth_[match.old_node], truth_.back()), match.old_T_node);
    right += off.translation().norm() < 0.5 && std::abs(off.theta) < 0.1 ? 1 : 0;
    EXPECT_GE(match.score, match.runner_up_score);
  }
  EXPECT_GE(right, 1);
}

TEST_F(PlaceSearching, FindsAPlaceInTheOtherDirection) {
  std::vector<SE2> poses = synthetic::DriveOnRing(0, 40, 1.0);
  for (int k = 39; k >= 12; --k) poses.push_back(poses[k] * SE2{0, 0, std::numbers::pi});
  Drive(poses, synthetic::Ring());
  int right = 0;
  for (const PlaceMatch& match : FindLast(20.0)) {
    const SE2 off = Between(Between(truth_[match.old_node], truth_.back()), match.old_T_node);
    right += off.translation().norm() < 0.5 && std::abs(off.theta) < 0.1 ? 1 : 0;
  }
  EXPECT_GE(right, 1);
}

TEST_F(PlaceSearching, LooksOnlyWhereItMay) {
  Drive(synthetic::DriveOnRing(0, 60, 1.0), synthetic::Ring());
  EXPECT_TRUE(FindLast(1000.0).empty());
}

TEST_F(PlaceSearching, ACorridorIsNoPlace) {
  std::vector<SE2> poses;
  for (int k = 0; k <= 60; ++k) poses.push_back({1.0 * k, 0.0, 0.0});
  Drive(poses, synthetic::Corridor(0.0));
  EXPECT_TRUE(FindLast(20.0).empty());
}

TEST_F(PlaceSearching, WhereNothingIsSeenIsNoPlace) {
  Drive(synthetic::DriveOnRing(0, 60, 1.0), {});
  EXPECT_TRUE(FindLast(20.0).empty());
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
