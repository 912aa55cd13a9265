// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/gauss_newton_matcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/frontend/scan_matching/gauss_newton_room.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

using GaussNewtonMatcherInRoom = GaussNewtonInRoom;

TEST_F(GaussNewtonMatcherInRoom, RecoversAPoseToAFractionOfACell) {
  const GaussNewtonMatcher matcher({}, {});
  std::vector<double> errors_m, errors_rad;
  for (int trial = 0; trial < 300; ++trial) {
    const SE2 truth = RandomPose(), start = Near(truth, 0.05, 2.0 * kDeg);
    const MatchResult result =
        matcher.Match(grid_, RoomPoints(truth), start, GaussNewton::WeakPrior());
    EXPECT_TRUE(result.success);
    const SE2 error = Between(truth, result.world_T_robot);
    errors_m.push_back(error.translation().norm());
    errors_rad.push_back(std::abs(error.theta));
  }
  std::sort(errors_m.begin(), errors_m.end());
  std::sort(errors_rad.begin(), errors_rad.end());
  EXPECT_LT(errors_m[150], 0.0005);  // a hundredth of a cell
  EXPECT_LT(errors_m.back(), 0.002);
  EXPECT_LT(errors_rad[150], 0.02 * kDeg);
  EXPECT_LT(errors_rad.back(), 0.1 * kDeg);
}

TEST_F(GaussNewtonMatcherInRoom, ScoreIsTheFitOfThePoseItReturnsAndNoLowerThanAtTheStart) {
  const GaussNewtonMatcher matcher({}, {});
  int moved = 0, stayed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const SE2 truth = RandomPose();
    const double spread = trial % 4 == 0 ? 2.0 : 0.1;
    const SE2 start = trial % 10 == 0 ? truth : Near(truth, spread, spread);
    const ScanPoints points = RoomPoints(truth);
    const MatchResult result = matcher.Match(grid_, points, start, GaussNewton::WeakPrior());
    EndpointModel model({}, &grid_, &points);
    ASSERT_EQ(result.score, model.Evaluate(result.world_T_robot).Fit()) << trial;
    ASSERT_GE(result.score, model.Evaluate(start).Fit()) << trial;
    ASSERT_EQ(result.success, result.score >= 0.2) << trial;
    ++(result.world_T_robot == start ? stayed : moved);
  }
  EXPECT_GT(moved, 50);
  EXPECT_GT(stayed, 5);
}

TEST_F(GaussNewtonMatcherInRoom, FusesThePriorWithTheScan) {
  const SE2 truth{0.2, 0.5, -2.0}, start{0.24, 0.46, -2.0};
  const Eigen::Matrix3d sure_of_x = Eigen::Vector3d(1e14, 1e-3, 1e-3).asDiagonal();
  const MatchResult result =
      GaussNewtonMatcher({}, {}).Match(grid_, RoomPoints(truth), start, sure_of_x);
  EXPECT_NEAR(result.world_T_robot.x, start.x, 1e-6);
  EXPECT_GT(result.world_T_robot.y, start.y + 0.02);
}

TEST_F(GaussNewtonMatcherInRoom, ScanWithoutPointsStaysWhereItIsAndFails) {
  const SE2 start{1, 2, 3};
  const GaussNewtonMatcher matcher({.alignment = {}, .min_score = 0.0}, {});  // any score would do
  const MatchResult result = matcher.Match(grid_, {}, start, GaussNewton::WeakPrior());
  EXPECT_FALSE(result.success);
  EXPECT_TRUE(result.world_T_robot == start);
}

TEST_F(GaussNewtonMatcherInRoom, PointsOutsideTheMapSayNothing) {
  const ScanPoints points = RoomPoints({});
  const map::OccupancyGrid empty({});
  const SE2 far_away{-5000, 7000, 1};
  for (const map::OccupancyGrid* grid : {&grid_, &empty}) {
    const MatchResult result =
        GaussNewtonMatcher({}, {}).Match(*grid, points, far_away, GaussNewton::WeakPrior());
    EXPECT_TRUE(result.world_T_robot == far_away);
  }
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
