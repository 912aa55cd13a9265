// SPDX-License-Identifier: BSD-3-Clause
// Matching where a direction is left open.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "backend/counter_random.h"
#include "backend/graph/pose_graph.h"
#include "frontend/map/scan_insertion.h"
#include "frontend/scan_matching/gauss_newton.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

// Whichever way it runs.
class GaussNewtonInCorridor : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Direction, GaussNewtonInCorridor, testing::Values(0.0, 0.35, 1.57, -0.8));

TEST_P(GaussNewtonInCorridor, InformationIsLongAcrossAndShortAlong) {
  const double direction_rad = GetParam();
  const map::OccupancyGrid grid = synthetic::CorridorMap(direction_rad);
  const SE2 pose{0.1, -0.2, direction_rad};
  const ScanPoints points =
      MakeScanPoints(synthetic::Scan(synthetic::Corridor(direction_rad), pose));
  const Eigen::Matrix3d information = GaussNewton({}).InformationAt(grid, points, pose);
  const Eigen::Vector2d along(std::cos(direction_rad), std::sin(direction_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Matrix2d xy = information.topLeftCorner<2, 2>();
  // Each beam measures the distance to its wall with the noise of an end point.
  const double expected = static_cast<double>(points.size()) / (0.02 * 0.02);
  EXPECT_NEAR(across.dot(xy * across), expected, 0.02 * expected);
  EXPECT_LT(along.dot(xy * along), 0.005 * expected);
  EXPECT_LT(std::abs(along.dot(xy * across)), 0.02 * expected);
}

TEST_P(GaussNewtonInCorridor, ScanIsMovedAcrossAndLeftWhereItIsAlong) {
  const double direction_rad = GetParam();
  const map::OccupancyGrid grid = synthetic::CorridorMap(direction_rad);
  const SE2 heading{0, 0, direction_rad}, truth = heading * SE2{0.4, 0.1, 0};
  const ScanPoints points =
      MakeScanPoints(synthetic::Scan(synthetic::Corridor(direction_rad), truth));
  const SE2 start = truth * SE2{0.2, 0.04, 0.02};
  for (const double prior : {1e-3, 1e4}) {
    const SE2 aligned = GaussNewton({})
                            .Align(grid, points, start, prior * Eigen::Matrix3d::Identity())
                            .world_T_robot;
    const SE2 error = Between(truth, aligned);
    EXPECT_NEAR(error.x, 0.2, 0.02);
    EXPECT_NEAR(error.y, 0.0, 0.002);
    EXPECT_NEAR(error.theta, 0.0, 0.001);
  }
}

// In the corridor, all round.
sensor::LaserScan NoisyScan(const SE2& pose, int beams, double noise_m,
                            backend::CounterRandom* random) {
  sensor::LaserScan scan = synthetic::Scan(
      synthetic::Corridor(pose.theta), pose,
      {.beams = beams, .field_of_view_rad = 2.0 * std::numbers::pi * (beams - 1) / beams});
  for (sensor::Beam& beam : scan.beams) beam.range_m += noise_m * random->Gaussian();
  return scan;
}

// Noise turns the normals of a wall this way and that: all of them together must not say where the
// robot is along it.
TEST_P(GaussNewtonInCorridor, NoisyRangesLeaveTheWayAlongItToThePrior) {
  const double direction_rad = GetParam();
  backend::CounterRandom random(6, 0);
  const SE2 heading{0, 0, direction_rad};
  const auto noisy = [&](const SE2& pose, int beams) {
    return NoisyScan(pose, beams, 0.01, &random);
  };
  for (const int beams : {24, 60, 360}) {
    map::OccupancyGrid grid({});
    for (int i = -10; i <= 10; ++i) {
      const SE2 pose = heading * SE2{0.5 * i, 0, 0};
      map::InsertScan(noisy(pose, beams), pose, {}, &grid);
    }
    double sum = 0.0;
    for (int trial = 0; trial < 20; ++trial) {
      const SE2 truth = heading * SE2{0.03 * trial, 0.1, 0};
      const SE2 start = truth * SE2{0.1, 0, 0};
      const Eigen::Matrix3d prior = backend::InformationFromSigmas(0.05, 0.02);
      const SE2 aligned = GaussNewton({})
                              .Align(grid, MakeScanPoints(noisy(truth, beams)), start, prior)
                              .world_T_robot;
      sum += Between(start, aligned).x;
    }
    // On average it goes nowhere, neither back to the truth nor on.
    EXPECT_NEAR(sum / 20, 0.0, 0.02) << beams;
  }
}

TEST_P(GaussNewtonInCorridor, WhoTrustsLeastStaysAtThePriorAlongItWhateverTheNoise) {
  backend::CounterRandom random(6, 0);
  const SE2 heading{0, 0, GetParam()};
  const auto noisy = [&](const SE2& pose) { return NoisyScan(pose, 720, 0.03, &random); };
  map::OccupancyGrid grid({});
  for (int i = -4; i <= 4; ++i) {
    const SE2 pose = heading * SE2{0.5 * i, 0, 0};
    map::InsertScan(noisy(pose), pose, {}, &grid);
  }
  const GaussNewton gauss_newton({});
  double usual_m = 0.0;
  for (int trial = 0; trial < 20; ++trial) {
    const SE2 truth = heading * SE2{0.03 * trial, 0.1, 0};
    const SE2 start = truth * SE2{0.1, 0.02, 0};
    const ScanPoints points = MakeScanPoints(noisy(truth));
    const auto align = [&](GaussNewton::Trust trust) {
      const Eigen::Matrix3d prior = backend::InformationFromSigmas(0.05, 0.02);
      return gauss_newton.Align(grid, points, start, prior, trust).world_T_robot;
    };
    EXPECT_FALSE(gauss_newton.TellsPosition(grid, points, truth));
    const SE2 aligned = align(GaussNewton::Trust::kLeast);
    EXPECT_NEAR(Between(start, aligned).x, 0.0, 0.001);
    EXPECT_NEAR(Between(truth, aligned).y, 0.0, 0.01);
    usual_m += std::abs(Between(start, align(GaussNewton::Trust::kUsual)).x) / 20;
  }
  EXPECT_GT(usual_m, 0.002);  // the noise of the normals moves a scan that is usually trusted
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
