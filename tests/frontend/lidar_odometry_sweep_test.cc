// SPDX-License-Identifier: BSD-3-Clause
// Drives with a laser that turns slowly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/frontend/lidar_odometry_drive.h"
#include "tests/frontend/moving_laser.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// Stands, and then turns on the spot, again and again; five scans a second, a sweep takes 0.18 s.
class SlowLaser : public testing::Test {
 protected:
  static constexpr double kInterval_s = 0.2;
  static constexpr double kSweep_s = 0.18;

  // The heading at the end, less what was estimated. `told_sweep_s`: by the log, as bags do.
  double TurnAndCompare(const std::optional<double>& known_sweep_s = std::nullopt,
                        double told_sweep_s = 0.0) {
    LidarOdometry::Options options;
    options.sweep_duration_s = known_sweep_s;
    LidarOdometry odometry(options);
    const synthetic::Laser laser{.beams = 361, .field_of_view_rad = 2.0 * std::numbers::pi};
    SE2 truth, estimate;
    for (int k = 0; k < 240; ++k) {
      const int in_turn = k % 30;
      const double turn_rad_s = std::clamp(0.4 * std::min(in_turn - 6, 29 - in_turn), 0.0, 1.2);
      const Eigen::Vector3d velocity(0.0, 0.0, turn_rad_s);
      const SE2 before = truth;
      truth = truth * backend::Exp(kInterval_s * velocity);
      const Eigen::Vector3d motion = kSweep_s * velocity;
      // Stamps are those of the first beam then.
      const SE2 middle = told_sweep_s > 0.0 ? truth * backend::Exp(0.5 * motion) : truth;
      sensor::LaserScan scan = synthetic::ScanOnTheMove(synthetic::Room(), middle, motion, laser);
      scan.sweep_s = told_sweep_s;
      scan.stamp_s = 10.0 + kInterval_s * k;
      const ScanMotion matched =
          odometry.MatchScan(scan, {k == 0 ? SE2{} : Between(before, truth)});
      estimate = k == 0 ? truth : estimate * matched.motion;
    }
    sweep_s_ = odometry.sweep_s();
    return std::abs(backend::WrapAngle(truth.theta - estimate.theta));
  }

  double sweep_s_ = 0.0;
};

TEST_F(SlowLaser, IsFoundOutAndItsScansAreDeskewed) {
  EXPECT_LT(TurnAndCompare(), 0.01);
  EXPECT_NEAR(sweep_s_, kSweep_s, 0.02);
}

TEST_F(SlowLaser, LosesItsHeadingWithoutThat) { EXPECT_GT(TurnAndCompare(0.0), 0.03); }

TEST_F(SlowLaser, MayBeTold) {
  EXPECT_LT(TurnAndCompare(kSweep_s), 0.01);
  EXPECT_EQ(sweep_s_, kSweep_s);
}

TEST_F(SlowLaser, MayBeToldByTheLog) {
  EXPECT_LT(TurnAndCompare({}, kSweep_s), 0.01);
  EXPECT_EQ(sweep_s_, kSweep_s);
}

TEST_F(SlowLaser, IsFoundOutWhereTheLogIsWrong) {
  EXPECT_LT(TurnAndCompare({}, 0.01), 0.01);
  EXPECT_NEAR(sweep_s_, kSweep_s, 0.02);
}

TEST_F(SlowLaser, TakesNoLongerThanFromScanToScan) {
  TurnAndCompare(0.9);
  EXPECT_NEAR(sweep_s_, kInterval_s, 0.01);
}

}  // namespace
}  // namespace gmapping_spa::frontend
