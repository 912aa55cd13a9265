// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/sweep_fit.h"

#include <gtest/gtest.h>

#include "tests/frontend/moving_laser.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

class SweepFitInARoom : public testing::Test {
 protected:
  SweepFit Fit(const Eigen::Vector3d& velocity, double true_sweep_s, double begin_s,
               const SE2& off = {}, int iterations = 20) {
    const sensor::LaserScan scan =
        synthetic::ScanOnTheMove(synthetic::Room(), pose_, true_sweep_s * velocity);
    return FitSweep(grid_, MakeScanPoints(scan), velocity,
                    {.world_T_robot = pose_ * off, .sweep_s = begin_s},
                    {.max_iterations = iterations});
  }

  const map::OccupancyGrid grid_ = synthetic::RoomMap();
  const SE2 pose_{0.4, -0.3, 0.8};
};

TEST_F(SweepFitInARoom, FindsHowLongTheSweepTakesInATurn) {
  for (const double sweep_s : {0.1, -0.1, 0.03}) {
    const SweepFit fit = Fit({0.2, 0.0, 1.0}, sweep_s, sweep_s + 0.02, {0.02, -0.02, 0.02});
    EXPECT_NEAR(fit.sweep_s, sweep_s, 0.005);
    EXPECT_LT(Between(pose_, fit.world_T_robot).translation().norm(), 0.01);
    EXPECT_NEAR(fit.world_T_robot.theta, pose_.theta, 0.005);
    EXPECT_GT(fit.information, 1.0 / (0.01 * 0.01));
  }
}

TEST_F(SweepFitInARoom, FindsItOnAStraightWayAsWell) {
  EXPECT_NEAR(Fit({1.5, 0.0, 0.0}, 0.1, 0.08).sweep_s, 0.1, 0.01);
}

TEST_F(SweepFitInARoom, MoreBeamsFitWithTheRightDuration) {
  const auto inliers_at = [&](double sweep_s) {
    return Fit({0.0, 0.0, 1.5}, 0.15, sweep_s, {}, 1).inliers;
  };
  EXPECT_GT(inliers_at(0.15), 1.5 * inliers_at(0.0));
}

TEST_F(SweepFitInARoom, ARobotThatStandsStillTellsNothing) {
  const SweepFit fit = Fit(Eigen::Vector3d::Zero(), 0.1, 0.05);
  EXPECT_NEAR(fit.information, 0.0, 1e-6);
  EXPECT_EQ(fit.sweep_s, 0.05);
}

TEST_F(SweepFitInARoom, WithoutPointsItIsWhatItWas) {
  const SweepFit fit = FitSweep(grid_, {}, {0, 0, 1}, {.world_T_robot = pose_, .sweep_s = 0.1}, {});
  EXPECT_EQ(fit.sweep_s, 0.1);
  EXPECT_EQ(fit.inliers, 0.0);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
