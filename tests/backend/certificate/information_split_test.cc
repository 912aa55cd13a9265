// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/information_split.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace gmapping_spa::backend {
namespace {

TEST(InformationSplit, IsTheMatrixItselfWhereItIsIsotropic) {
  const InformationSplit split =
      SplitInformation(Eigen::Vector3d(44.7, 44.7, 9000.0).asDiagonal().toDenseMatrix());
  EXPECT_NEAR(split.translation, 44.7, 1e-12);
  EXPECT_EQ(split.rotation, 9000.0);
}

TEST(InformationSplit, IsTheSmallestEigenvalueWhereOnlyTheTranslationIsCoupled) {
  Eigen::Matrix3d information = Eigen::Vector3d(5.0, 5.0, 7.0).asDiagonal();
  information(0, 1) = information(1, 0) = 3.0;
  const InformationSplit split = SplitInformation(information);
  EXPECT_NEAR(split.translation, 2.0, 1e-12);
  EXPECT_EQ(split.rotation, 7.0);
}

TEST(InformationSplit, LeavesAPositiveSemidefiniteMatrix) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 300; ++k) {
    Eigen::Matrix3d root;
    for (double& entry : root.reshaped()) entry = normal(random);
    // Up to nearly singular and far from isotropic.
    root.row(0) *= std::pow(10.0, k % 7);
    const Eigen::Matrix3d information = root * root.transpose();
    const InformationSplit split = SplitInformation(information);
    const Eigen::Matrix3d rest =
        information - Eigen::Vector3d(split.translation, split.translation, split.rotation)
                          .asDiagonal()
                          .toDenseMatrix();
    const Eigen::Vector3d eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(rest).eigenvalues();
    EXPECT_GE(eigenvalues(0), -1e-14 * eigenvalues(2)) << k;
    EXPECT_GE(split.translation, 0.0);
    EXPECT_GE(split.rotation, 0.0);
  }
}

TEST(InformationSplit, IsNothingWhereACoupledDirectionIsNotKnown) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  information.bottomRightCorner<2, 2>() << 4.0, 2.0, 2.0, 1.0;
  const InformationSplit split = SplitInformation(information);
  EXPECT_EQ(split.translation, 0.0);
  EXPECT_EQ(split.rotation, 0.0);
}

}  // namespace
}  // namespace gmapping_spa::backend
