// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/edge_error.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace gmapping_spa::backend {
namespace {

constexpr double kPi = std::numbers::pi;

SE2 Moved(SE2 pose, int coordinate, double by) {
  (coordinate == 0 ? pose.x : coordinate == 1 ? pose.y : pose.theta) += by;
  return pose;
}

TEST(EdgeError, IsZeroForAPerfectMeasurement) {
  const SE2 i{1, 2, 3}, j{-4, 5, -2.5};
  EXPECT_LT(EdgeError(i, j, Between(i, j)).norm(), 1e-14);
}

TEST(EdgeError, ExpressesTranslationInFrameI) {
  const Eigen::Vector3d error = EdgeError({1, 1, kPi / 2}, {1, 4, kPi / 2}, {1, 0, 0});
  EXPECT_LT((error - Eigen::Vector3d(2, 0, 0)).norm(), 1e-14);
}

TEST(EdgeError, WrapsTheAngle) {
  EXPECT_NEAR(EdgeError({0, 0, kPi - 0.1}, {0, 0, -kPi + 0.1}, {}).z(), 0.2, 1e-14);
  EXPECT_NEAR(EdgeError({0, 0, 7 * kPi}, {0, 0, 0}, {0, 0, -kPi + 0.1}).z(), -0.1, 1e-13);
}

TEST(LinearizeEdge, AgreesWithFiniteDifferences) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-5.0, 5.0);
  const auto any_pose = [&] { return SE2{uniform(random), uniform(random), uniform(random)}; };
  for (int trial = 0; trial < 200; ++trial) {
    const SE2 i = any_pose(), j = any_pose();
    // Away from the jump of the angle at pi.
    const SE2 measured = Between(i, j) * SE2{uniform(random), uniform(random), uniform(random) / 5};
    const LinearizedEdge edge = LinearizeEdge(i, j, measured);
    EXPECT_LT((edge.error - EdgeError(i, j, measured)).norm(), 1e-13);
    constexpr double kStep = 1e-6;
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector3d by_i = (EdgeError(Moved(i, c, kStep), j, measured) -
                                    EdgeError(Moved(i, c, -kStep), j, measured)) /
                                   (2 * kStep);
      const Eigen::Vector3d by_j = (EdgeError(i, Moved(j, c, kStep), measured) -
                                    EdgeError(i, Moved(j, c, -kStep), measured)) /
                                   (2 * kStep);
      EXPECT_LT((edge.jacobian_i.col(c) - by_i).norm(), 1e-8);
      EXPECT_LT((edge.jacobian_j.col(c) - by_j).norm(), 1e-8);
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::backend
