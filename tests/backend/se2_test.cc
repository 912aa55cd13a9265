// SPDX-License-Identifier: BSD-3-Clause
#include "backend/se2.h"

#include <gtest/gtest.h>

#include <limits>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

namespace gmapping_spa::backend {
namespace {

std::vector<SE2> SomePoses() {
  std::vector<SE2> poses = {{0, 0, 0}, {1, 2, 3.1}, {-4, 0.5, -3.1}, {1e-3, -2e-3, 1e-6}};
  for (int k = 0; k < 20; ++k) {
    poses.push_back({std::sin(1.0 + k) * 10, std::cos(3.0 * k) * 5, WrapAngle(0.7 * k)});
  }
  return poses;
}

Eigen::Matrix3d Homogeneous(const SE2& pose) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  m.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(pose.theta).toRotationMatrix();
  m.topRightCorner<2, 1>() = pose.translation();
  return m;
}

TEST(SE2, CompositionAndInverseAgreeWithHomogeneousMatrices) {
  for (const SE2& a : SomePoses()) {
    EXPECT_TRUE(Homogeneous(Inverse(a)).isApprox(Homogeneous(a).inverse(), 1e-12));
    for (const SE2& b : SomePoses()) {
      EXPECT_TRUE(Homogeneous(a * b).isApprox(Homogeneous(a) * Homogeneous(b), 1e-12));
      EXPECT_TRUE(
          Homogeneous(Between(a, b)).isApprox(Homogeneous(a).inverse() * Homogeneous(b), 1e-12));
    }
  }
}

TEST(SE2, MovesPointsLikeItsMatrix) {
  const Eigen::Vector2d point(0.3, -2.0);
  for (const SE2& a : SomePoses()) {
    EXPECT_TRUE((a * point).isApprox((Homogeneous(a) * point.homogeneous()).head<2>(), 1e-12));
  }
}

TEST(SE2, PlusChangesCoordinatesAndWrapsTheAngle) {
  const SE2 pose = Plus({1.0, -2.0, 3.0}, {0.5, 0.25, 1.0});
  EXPECT_EQ(pose.x, 1.5);
  EXPECT_EQ(pose.y, -1.75);
  EXPECT_NEAR(pose.theta, 4.0 - 2.0 * std::numbers::pi, 1e-15);
}

TEST(SE2, PlusUndoesMinus) {
  for (const SE2& a : SomePoses()) {
    for (const SE2& b : SomePoses()) {
      EXPECT_TRUE(Homogeneous(Plus(a, Minus(b, a))).isApprox(Homogeneous(b), 1e-12));
      EXPECT_LE(std::abs(Minus(b, a).z()), std::numbers::pi);
    }
  }
}

TEST(SE2, ExpIsTheMatrixExponential) {
  for (const double w : {0.0, 1e-9, 1e-5, 9e-5, 1.1e-4, 0.5, -2.0, 3.1}) {
    const Eigen::Vector3d twist(0.7, -1.3, w);
    Eigen::Matrix3d algebra;
    algebra << 0, -w, twist.x(), w, 0, twist.y(), 0, 0, 0;
    EXPECT_TRUE(Homogeneous(Exp(twist)).isApprox(algebra.exp(), 1e-12)) << w;
  }
}

TEST(SE2, LogInvertsExp) {
  for (const double w : {0.0, 1e-9, 1e-5, 9e-5, 1.1e-4, 0.5, -2.0, 3.1}) {
    const Eigen::Vector3d twist(0.7, -1.3, w);
    EXPECT_TRUE(Log(Exp(twist)).isApprox(twist, 1e-12)) << w;
  }
}

TEST(SE2, WrapAngleStaysWithinPiAndKeepsTheDirection) {
  for (double theta = -50.0; theta < 50.0; theta += 0.37) {
    const double wrapped = WrapAngle(theta);
    EXPECT_LE(std::abs(wrapped), std::numbers::pi);
    EXPECT_NEAR(std::sin(wrapped), std::sin(theta), 1e-12);
    EXPECT_NEAR(std::cos(wrapped), std::cos(theta), 1e-12);
  }
}

TEST(SE2, IsFiniteSeesEveryComponent) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE((SE2{1, 2, 3}.IsFinite()));
  EXPECT_FALSE((SE2{nan, 2, 3}.IsFinite()));
  EXPECT_FALSE((SE2{1, nan, 3}.IsFinite()));
  EXPECT_FALSE((SE2{1, 2, nan}.IsFinite()));
}

}  // namespace
}  // namespace gmapping_spa::backend
