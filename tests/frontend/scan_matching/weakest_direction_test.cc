// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/weakest_direction.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace gmapping_spa::scan_matching {
namespace {

TEST(WeakestDirection, IsThatOfACorridorWhateverTheHeadingIs) {
  for (const double turn_rad : {0.0, 0.4, 2.0}) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(turn_rad).toRotationMatrix();
    // Across 400, along 9; the heading is off with the place across.
    Eigen::Matrix3d information;
    information << 9, 0, 0, 0, 500, 50, 0, 50, 25;
    const WeakestDirection found = FindWeakestDirection(turn * information * turn.transpose());
    EXPECT_NEAR(found.information, 9.0, 1e-9);
    EXPECT_NEAR(std::abs(found.direction.dot(turn.topLeftCorner<2, 1>())), 1.0, 1e-9);
  }
}

TEST(WeakestDirection, AScanWithoutPointsSaysNothing) {
  EXPECT_EQ(FindWeakestDirection(Eigen::Matrix3d::Zero()).information, 0.0);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
