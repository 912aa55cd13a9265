// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/hill_climbing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "backend/counter_random.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::scan_matching::hill_climbing_test {
namespace {

using backend::SE2;

constexpr double kDeg = std::numbers::pi / 180.0;
const Eigen::Matrix3d kNoPrior = Eigen::Matrix3d::Zero();

TEST(HillClimbing, RecoversAPoseToACentimetreAndNineteenInTwentyToAFifthOfADegree) {
  const map::OccupancyGrid grid = synthetic::RoomMap();
  const HillClimbing matcher({}, {});
  backend::CounterRandom random(11, 0);
  const auto offset = [&](double limit) { return limit * (2.0 * random.Uniform() - 1.0); };
  std::vector<double> errors_m, errors_rad;
  for (int trial = 0; trial < 300; ++trial) {
    const SE2 truth{offset(1.2), offset(1.0), offset(std::numbers::pi)};
    const ScanPoints points = MakeScanPoints(synthetic::Scan(synthetic::Room(), truth));
    const SE2 start = truth * SE2{offset(0.1), offset(0.1), offset(4.0 * kDeg)};
    const MatchResult result = matcher.Match(grid, points, start, kNoPrior);
    EXPECT_TRUE(result.success);
    const SE2 error = Between(truth, result.world_T_robot);
    errors_m.push_back(error.translation().norm());
    errors_rad.push_back(std::abs(error.theta));
  }
  std::sort(errors_m.begin(), errors_m.end());
  std::sort(errors_rad.begin(), errors_rad.end());
  EXPECT_LT(errors_m.back(), 0.01);
  // The last step tried is 0.09 deg; where few beams fix the angle, a start in a hundred ends a
  // little beyond 0.2 deg (0.29 deg is the worst of these).
  EXPECT_LT(errors_rad[285], 0.2 * kDeg);
  EXPECT_LT(errors_rad.back(), 0.35 * kDeg);
}

TEST(HillClimbing, ScoreIsThatOfThePoseItReturnsAndNoWorseThanAtTheStart) {
  const map::OccupancyGrid grid = synthetic::RoomMap();
  const SE2 truth{0.2, 0.5, -2.0};
  const ScanPoints points = MakeScanPoints(synthetic::Scan(synthetic::Room(), truth));
  const HillClimbing matcher({}, {});
  EndpointModel model({}, &grid, &points);
  for (const double offset : {0.0, 0.05, 0.3, 2.0}) {
    const SE2 start = truth * SE2{offset, -offset, 0.1 * offset};
    const MatchResult result = matcher.Match(grid, points, start, kNoPrior);
    EXPECT_EQ(result.score, model.Score(result.world_T_robot));
    EXPECT_GE(result.score, model.Score(start));
  }
}

TEST(HillClimbing, SaysThatItFailedOnAnEmptyMap) {
  const map::OccupancyGrid empty({});
  const ScanPoints points = MakeScanPoints(synthetic::Scan(synthetic::Room(), {}));
  const MatchResult result = HillClimbing({}, {}).Match(empty, points, {1, 2, 3}, kNoPrior);
  EXPECT_FALSE(result.success);
  EXPECT_EQ(result.score, 0.0);
  EXPECT_TRUE((result.world_T_robot == SE2{1, 2, 3}));
}

TEST(HillClimbing, SaysThatItFailedOnAScanWithoutPoints) {
  const map::OccupancyGrid grid = synthetic::RoomMap();
  // Even where any score at all would do.
  const MatchResult result =
      HillClimbing({.min_score = 0.0}, {}).Match(grid, {}, {1, 2, 3}, kNoPrior);
  EXPECT_FALSE(result.success);
  EXPECT_TRUE((result.world_T_robot == SE2{1, 2, 3}));
}

TEST(HillClimbing, FailsBelowTheMinimumScore) {
  const map::OccupancyGrid grid = synthetic::RoomMap();
  const SE2 truth{0.2, 0.5, -2.0};
  const ScanPoints points = MakeScanPoints(synthetic::Scan(synthetic::Room(), truth));
  const double score = HillClimbing({}, {}).Match(grid, points, truth, kNoPrior).score;
  EXPECT_TRUE(HillClimbing({.min_score = score}, {}).Match(grid, points, truth, kNoPrior).success);
  EXPECT_FALSE(
      HillClimbing({.min_score = score + 1e-6}, {}).Match(grid, points, truth, kNoPrior).success);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching::hill_climbing_test
