// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/edge_bound.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "backend/cost/edge_error.h"

namespace gmapping_spa::backend::edge_bound_test {
namespace {

// An edge between two poses, of which the first one is the identity, with its bound there.
class EdgeBoundTest : public ::testing::Test {
 protected:
  double Normal(double sigma) { return sigma * normal_(random_); }
  double Angle() { return std::uniform_real_distribution<double>(-3.1, 3.1)(random_); }
  SE2 AnyPose() { return {Normal(3.0), Normal(3.0), Angle()}; }

  Edge AnyEdge(bool isotropic) {
    Edge edge;
    edge.i_T_j = AnyPose();
    if (isotropic) {
      edge.information = InformationFromSigmas(0.2, 0.1);
    } else {
      Eigen::Matrix3d root;
      for (double& entry : root.reshaped()) entry = Normal(5.0);
      edge.information = root * root.transpose();
    }
    return edge;
  }

  static double Cost(const Edge& edge, const SE2& i_T_j) {
    const Eigen::Vector3d error = Minus(i_T_j, edge.i_T_j);
    return 0.5 * error.dot(edge.information * error);
  }

  // The bound at another relative pose than that it was made for, by its definition.
  static double Value(const EdgeBound& bound, const SE2& i_T_j) {
    const Complex t(i_T_j.x, i_T_j.y);
    return 0.5 * bound.tau * std::norm(t) - std::real(std::conj(t) * bound.b) +
           std::real(bound.h * std::polar(1.0, i_T_j.theta));
  }

  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
};

TEST_F(EdgeBoundTest, IsNowhereAboveTheCost) {
  for (int k = 0; k < 200; ++k) {
    const Edge edge = AnyEdge(k % 2 == 0);
    const SE2 at = AnyPose();
    // The error at a pose, or another one.
    const Eigen::Vector3d tangent =
        k % 3 == 0 ? Eigen::Vector3d{Normal(1), Normal(1), Angle()} : Minus(at, edge.i_T_j);
    const EdgeBound bound = BoundEdge(edge, SplitInformation(edge.information), at, tangent);
    EXPECT_GE(bound.slack, 0.0);
    for (int other = 0; other < 300; ++other) {
      const SE2 pose = other % 3 == 0
                           ? Plus(at, Eigen::Vector3d{Normal(0.1), Normal(0.1), Normal(0.1)})
                           : AnyPose();
      const double cost = Cost(edge, pose);
      const double value = Cost(edge, at) - bound.slack + Value(bound, pose) - Value(bound, at);
      EXPECT_LE(value, cost + 1e-9 * (1.0 + cost + std::abs(value))) << k;
    }
  }
}

TEST_F(EdgeBoundTest, TouchesTheCostAtTheTangentWithTheSameGradient) {
  for (int k = 0; k < 100; ++k) {
    const Edge edge = AnyEdge(k % 2 == 0);
    const SE2 at = AnyPose();
    const EdgeBound bound =
        BoundEdge(edge, SplitInformation(edge.information), at, Minus(at, edge.i_T_j));
    EXPECT_EQ(bound.slack, 0.0);
    const LinearizedEdge linearized = LinearizeEdge({}, at, edge.i_T_j);
    const Eigen::Vector3d weighted = edge.information * linearized.error;
    const Eigen::Vector3d by_j = linearized.jacobian_j.transpose() * weighted;
    const Eigen::Vector3d by_i = linearized.jacobian_i.transpose() * weighted;
    const double scale = 1e-10 * (1.0 + weighted.norm() * (1.0 + edge.i_T_j.translation().norm()));
    EXPECT_NEAR(bound.force.real(), by_j.x(), scale);
    EXPECT_NEAR(bound.force.imag(), by_j.y(), scale);
    EXPECT_NEAR(bound.torque_j, by_j.z(), scale);
    EXPECT_NEAR(bound.torque_i, by_i.z(), 10.0 * scale);
  }
}

TEST_F(EdgeBoundTest, HasAsMuchCurvatureAsTheChordalCostWhereTheAngleIsItsOnlyError) {
  // Then d^2 is convex in u = 2 (1 - cos d), and the tangent there has the derivative d / sin d.
  Edge edge;
  edge.information = InformationFromSigmas(1.0, 0.5);
  for (const double d : {0.1, 1.0, 2.0, 3.0}) {
    const EdgeBound bound =
        BoundEdge(edge, SplitInformation(edge.information), {0.0, 0.0, d}, {0.0, 0.0, d});
    EXPECT_NEAR(std::abs(bound.h), 4.0 * d / std::sin(d), 1e-9) << d;
    EXPECT_NEAR(std::arg(-bound.h), 0.0, 1e-12) << d;
  }
}

TEST_F(EdgeBoundTest, IsNotFiniteWhereTheAngleIsPi) {
  Edge edge;
  edge.information = InformationFromSigmas(1.0, 1.0);
  edge.information(2, 2) = 0.0;
  edge.information(0, 2) = edge.information(2, 0) = 0.5;
  const double pi = std::numbers::pi;
  EXPECT_FALSE(std::isfinite(BoundEdge(edge, {0.0, 0.0}, {1.0, 0.0, pi}, {1.0, 0.0, pi}).h.real()));
}

}  // namespace
}  // namespace gmapping_spa::backend::edge_bound_test
