// SPDX-License-Identifier: BSD-3-Clause
// The best places of a window, one after another.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "frontend/scan_matching/correlative_matching.h"
#include "frontend/scan_matching/joined_points.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;
using Points = std::vector<Eigen::Vector2d>;

Points RoomSeenFrom(const SE2& world_T_robot) {
  return PositionsOf(MakeScanPoints(synthetic::Scan(synthetic::Room(), world_T_robot)));
}

// The same room three times, each a little more spoiled, at places that are known.
TEST(CorrelativePeaks, PeaksAreTheBestPlacesInOrderEachFarFromTheBetterOnes) {
  const Points room = RoomSeenFrom({0.5, 0.2, 0.3});
  Points reference;
  const std::vector<SE2> places = {{0, 0, 0}, {15, 3, 0.4}, {-4, 14, -0.8}};
  for (std::size_t place = 0; place < places.size(); ++place) {
    for (std::size_t k = 0; k < room.size(); ++k) {
      if (k % 8 >= place) reference.push_back(places[place] * room[k]);
    }
  }
  CorrelativeMatcher::Options options;
  options.runner_up_floor = 0.6;
  const CorrelativeMatcher matcher(options, reference);
  const std::vector<ScoredPose> peaks = matcher.Peaks(room, {}, {20.0, std::numbers::pi}, 3);
  ASSERT_EQ(peaks.size(), 3u);
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    const SE2 off = Between(places[k], peaks[k].map_T_scan);
    EXPECT_LT(off.translation().norm(), 0.1) << k;
    EXPECT_LT(std::abs(off.theta), 0.035) << k;
    EXPECT_TRUE(k == 0 || peaks[k].score < peaks[k - 1].score) << k;
  }
  const CorrelativeMatch match = matcher.Match(room, {}, {20.0, std::numbers::pi});
  EXPECT_EQ(match.map_T_scan, peaks[0].map_T_scan);
  EXPECT_EQ(match.runner_up_map_T_scan, peaks[1].map_T_scan);
  EXPECT_EQ(match.runner_up_score, peaks[1].score);
}

TEST(CorrelativePeaks, ThereAreNoPeaksOfNoPointsNorBelowTheLeastScore) {
  const Points room = RoomSeenFrom({});
  CorrelativeMatcher::Options options;
  EXPECT_TRUE(CorrelativeMatcher(options, room).Peaks({}, {}, {1.0, 0.1}, 5).empty());
  options.min_score = 0.9;
  EXPECT_TRUE(CorrelativeMatcher(options, {{50, 50}}).Peaks(room, {}, {1.0, 0.1}, 5).empty());
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
