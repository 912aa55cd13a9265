// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/gauss_newton.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/frontend/scan_matching/gauss_newton_room.h"
#include "tests/frontend/scan_matching/normal_equations.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

TEST_F(GaussNewtonInRoom, InformationIsThatOfTheMapItself) {
  const GaussNewton::Options options{.noise_sigma_m = 0.03, .robust_sigmas = 1.5};
  for (int trial = 0; trial < 50; ++trial) {
    const SE2 truth = RandomPose(), pose = Near(truth, 0.1, 4.0 * kDeg);
    const ScanPoints points = RoomPoints(truth);
    const Eigen::Matrix3d expected = NormalEquations(grid_, points, pose, options).hessian;
    const Eigen::Matrix3d information = GaussNewton(options).InformationAt(grid_, points, pose);
    ASSERT_LT((information - expected).norm(), 1e-3 * expected.norm()) << trial;
    ASSERT_TRUE(information == information.transpose());
  }
}

TEST_F(GaussNewtonInRoom, StepIsThatOfTheNormalEquationsWithThePrior) {
  const GaussNewton::Options options{.max_iterations = 1};
  const GaussNewton gauss_newton(options);
  const Eigen::Matrix3d prior = Eigen::Vector3d(3e3, 1e4, 2e5).asDiagonal();
  for (int trial = 0; trial < 50; ++trial) {
    const SE2 truth = RandomPose(), start = Near(truth, 0.05, 2.0 * kDeg);
    const ScanPoints points = RoomPoints(truth);
    const Reference sum = NormalEquations(grid_, points, start, options);
    const Eigen::Vector3d step = -(sum.hessian + prior).inverse() * sum.gradient;
    const GaussNewton::Alignment alignment = gauss_newton.Align(grid_, points, start, prior);
    ASSERT_NEAR(alignment.world_T_robot.x, start.x + step.x(), 1e-4) << trial;
    ASSERT_NEAR(alignment.world_T_robot.y, start.y + step.y(), 1e-4) << trial;
    const double turned = backend::WrapAngle(alignment.world_T_robot.theta - start.theta);
    ASSERT_NEAR(turned, step.z(), 1e-4) << trial;
    ASSERT_GT(step.head<2>().norm() + std::abs(step.z()), 1e-3) << trial;
    ASSERT_NEAR(alignment.inliers, sum.inliers, 1e-2) << trial;
    ASSERT_LT((alignment.world_information - sum.hessian).norm(), 1e-3 * sum.hessian.norm());
  }
}

TEST_F(GaussNewtonInRoom, EndsWhereGradientAndPriorAreInBalance) {
  const GaussNewton::Options options{.max_iterations = 100, .step_tolerance = 1e-6};
  const GaussNewton gauss_newton(options);
  const Eigen::Matrix3d prior = Eigen::Vector3d(3e3, 1e4, 2e5).asDiagonal();
  for (int trial = 0; trial < 20; ++trial) {
    const SE2 truth = RandomPose(), start = Near(truth, 0.05, 2.0 * kDeg);
    const ScanPoints points = RoomPoints(truth);
    const SE2 end = gauss_newton.Align(grid_, points, start, prior).world_T_robot;
    const Reference sum = NormalEquations(grid_, points, end, options);
    const Eigen::Vector3d moved = Minus(end, start);
    const Eigen::Vector3d step = (sum.hessian + prior).inverse() * (sum.gradient + prior * moved);
    EXPECT_LT(step.cwiseAbs().maxCoeff(), 1e-4) << trial;
  }
}

TEST_F(GaussNewtonInRoom, StrongPriorKeepsTheInitialPose) {
  const SE2 truth{0.2, 0.5, -2.0}, start = truth * SE2{0.03, -0.02, 0.01};
  const ScanPoints points = RoomPoints(truth);
  const GaussNewton gauss_newton({});
  const SE2 held =
      gauss_newton.Align(grid_, points, start, 1e14 * Eigen::Matrix3d::Identity()).world_T_robot;
  EXPECT_NEAR(held.x, start.x, 1e-6);
  EXPECT_NEAR(held.y, start.y, 1e-6);
  EXPECT_NEAR(held.theta, start.theta, 1e-6);
  const SE2 free = gauss_newton.Align(grid_, points, start, GaussNewton::WeakPrior()).world_T_robot;
  EXPECT_GT(Between(start, free).translation().norm(), 0.02);
}

TEST_F(GaussNewtonInRoom, PriorHoldsOnlyWhatItIsSureOf) {
  const SE2 truth{0.2, 0.5, -2.0}, start{0.24, 0.46, -2.0};
  const Eigen::Matrix3d sure_of_x = Eigen::Vector3d(1e14, 1e-3, 1e-3).asDiagonal();
  const SE2 aligned =
      GaussNewton({}).Align(grid_, RoomPoints(truth), start, sure_of_x).world_T_robot;
  EXPECT_NEAR(aligned.x, start.x, 1e-6);
  EXPECT_GT(aligned.y, start.y + 0.02);
}

TEST_F(GaussNewtonInRoom, ScanWithoutPointsStaysWhereItIs) {
  const SE2 start{1, 2, 3};
  const GaussNewton gauss_newton({});
  const GaussNewton::Alignment alignment =
      gauss_newton.Align(grid_, {}, start, GaussNewton::WeakPrior());
  EXPECT_TRUE(alignment.world_T_robot == start);
  EXPECT_TRUE(alignment.world_information.isZero(0.0));
  EXPECT_EQ(alignment.inliers, 0.0);
}

TEST_F(GaussNewtonInRoom, PointsOutsideTheMapSayNothing) {
  const ScanPoints points = RoomPoints({});
  const map::OccupancyGrid empty({});
  const SE2 far_away{-5000, 7000, 1};
  for (const map::OccupancyGrid* grid : {&grid_, &empty}) {
    const GaussNewton gauss_newton({});
    EXPECT_TRUE(gauss_newton.InformationAt(*grid, points, far_away).isZero(0.0));
    EXPECT_TRUE(
        gauss_newton.Align(*grid, points, far_away, GaussNewton::WeakPrior()).world_T_robot ==
        far_away);
  }
}

TEST_F(GaussNewtonInRoom, PointsThatMeetNothingDoNotDisturbTheOthers) {
  const SE2 truth{0.2, 0.5, -2.0}, start = truth * SE2{0.03, -0.02, 0.01};
  ScanPoints points = RoomPoints(truth);
  const GaussNewton gauss_newton({});
  const GaussNewton::Alignment alone =
      gauss_newton.Align(grid_, points, start, GaussNewton::WeakPrior());
  for (int i = 0; i < 50; ++i) points.push_back({100.0 + i, -300.0, -1.0, 0.0});
  const GaussNewton::Alignment with =
      gauss_newton.Align(grid_, points, start, GaussNewton::WeakPrior());
  EXPECT_TRUE(with.world_T_robot == alone.world_T_robot);
  EXPECT_EQ(with.inliers, alone.inliers);
  EXPECT_GT(alone.inliers, 0.8 * static_cast<double>(points.size() - 50));
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
