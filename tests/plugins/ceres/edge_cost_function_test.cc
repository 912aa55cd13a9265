// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/ceres/edge_cost_function.h"

#include <ceres/autodiff_cost_function.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gmapping_spa::ceres_backend {
namespace {

// The error written down a second time, for Ceres' automatic derivatives.
struct AutomaticError {
  backend::SE2 i_T_j;
  Eigen::Matrix3d root;

  template <typename T>
  bool operator()(const T* pose_i, const T* pose_j, T* residuals) const {
    const T c = cos(pose_i[2]), s = sin(pose_i[2]);
    const T dx = pose_j[0] - pose_i[0], dy = pose_j[1] - pose_i[1];
    const T angle = pose_j[2] - pose_i[2] - i_T_j.theta;
    const Eigen::Matrix<T, 3, 1> error(c * dx + s * dy - i_T_j.x, c * dy - s * dx - i_T_j.y,
                                       atan2(sin(angle), cos(angle)));
    Eigen::Map<Eigen::Matrix<T, 3, 1>> whitened(residuals);
    whitened = root.cast<T>() * error;
    return true;
  }
};

TEST(EdgeCostFunction, AgreesWithAutomaticDerivatives) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-6.0, 6.0);
  for (int trial = 0; trial < 300; ++trial) {
    backend::Edge edge;
    edge.i_T_j = {uniform(random), uniform(random), uniform(random)};
    Eigen::Matrix3d root;
    for (double& entry : root.reshaped()) entry = uniform(random);
    edge.information = root.transpose() * root + Eigen::Matrix3d::Identity();
    double pose_i[3], pose_j[3];
    for (int c = 0; c < 3; ++c) {
      pose_i[c] = uniform(random);
      pose_j[c] = uniform(random);
    }
    const double* poses[] = {pose_i, pose_j};

    const EdgeCostFunction analytic(edge);
    const ::ceres::AutoDiffCostFunction<AutomaticError, 3, 3, 3> automatic(
        new AutomaticError{edge.i_T_j, SquareRootInformation(edge.information)});
    Eigen::Vector3d residuals[2];
    Eigen::Matrix<double, 3, 3, Eigen::RowMajor> jacobians[2][2];
    double* first[] = {jacobians[0][0].data(), jacobians[0][1].data()};
    double* second[] = {jacobians[1][0].data(), jacobians[1][1].data()};
    ASSERT_TRUE(analytic.Evaluate(poses, residuals[0].data(), first));
    ASSERT_TRUE(automatic.Evaluate(poses, residuals[1].data(), second));
    EXPECT_LT((residuals[0] - residuals[1]).norm(), 1e-10);
    for (int block = 0; block < 2; ++block) {
      EXPECT_LT((jacobians[0][block] - jacobians[1][block]).norm(), 1e-10);
    }
  }
}

TEST(SquareRootInformation, ReproducesTheInformation) {
  Eigen::Matrix3d definite;
  definite << 4, 1, 0, 1, 3, 0.5, 0, 0.5, 2;
  const Eigen::Matrix3d semidefinite = Eigen::Vector3d(1, 2, 3) * Eigen::RowVector3d(1, 2, 3);
  for (const Eigen::Matrix3d& information :
       {definite, semidefinite, Eigen::Matrix3d(Eigen::Matrix3d::Zero())}) {
    const Eigen::Matrix3d root = SquareRootInformation(information);
    EXPECT_LT((root.transpose() * root - information).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace gmapping_spa::ceres_backend
