#include "frontend/scan_odometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// Around the middle of the room, a round in 80 steps of about 0.1 m.
SE2 OnRound(int step) {
  const double around = 2.0 * std::numbers::pi * step / 80.0;
  return {1.3 * std::cos(around), 1.3 * std::sin(around),
          backend::WrapAngle(around + std::numbers::pi / 2)};
}

class ScanOdometryInARoom : public testing::Test {
 protected:
  // The motion to the step, told by wheels that are off by `slip`.
  SE2 DriveTo(int step, const SE2& slip = {}) {
    const SE2 wheels = step == 0 ? SE2{} : Between(OnRound(step - 1), OnRound(step)) * slip;
    const SE2 motion =
        odometry_.Advance(synthetic::Scan(synthetic::Room(), OnRound(step), laser_), wheels);
    estimate_ = estimate_ * motion;
    return motion;
  }

  static void ExpectNear(const SE2& found, const SE2& expected, double m, double rad) {
    const SE2 off = Between(expected, found);
    EXPECT_LT(off.translation().norm(), m);
    EXPECT_LT(std::abs(off.theta), rad);
  }

  ScanOdometry odometry_{{}};
  synthetic::Laser laser_;
  SE2 estimate_;  // in the frame of step 0
};

TEST_F(ScanOdometryInARoom, TheFirstScanIsNoMotion) {
  const sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), {});
  EXPECT_TRUE((odometry_.Advance(scan, {1, 2, 3}) == SE2{}));
}

TEST_F(ScanOdometryInARoom, FindsTheMotionInSpiteOfWheelsThatSlip) {
  const SE2 slip{0.02, 0.005, 0.01};
  SE2 wheels;
  for (int step = 0; step <= 160; ++step) {
    DriveTo(step, slip);
    if (step > 0) wheels = wheels * Between(OnRound(step - 1), OnRound(step)) * slip;
  }
  const SE2 truth = Between(OnRound(0), OnRound(160));
  ASSERT_GT(Between(truth, wheels).translation().norm(), 0.5);
  ExpectNear(estimate_, truth, 0.03, 0.01);
}

TEST_F(ScanOdometryInARoom, SearchesWhereTheWheelsHaveJumped) {
  int step = 0;
  for (; step < 40; ++step) DriveTo(step);
  for (const SE2 jump : {SE2{0.25, 0, 0.3}, SE2{-0.2, 0.2, -0.3}, SE2{0, -0.25, 0.35}}) {
    ExpectNear(DriveTo(step, jump), Between(OnRound(step - 1), OnRound(step)), 0.02, 0.01);
    ++step;
  }
}

TEST_F(ScanOdometryInARoom, BlindScansFollowTheWheels) {
  for (int step = 0; step < 40; ++step) DriveTo(step);
  for (const SE2 wheels : {SE2{0.1, 0, 0.05}, SE2{0.7, 0.1, -0.4}, SE2{}}) {
    const SE2 motion = odometry_.Advance(sensor::LaserScan{}, wheels);
    EXPECT_LT(Log(Between(wheels, motion)).norm(), 1e-9);
  }
}

TEST_F(ScanOdometryInARoom, GoesOnAfterBlindScans) {
  for (int step = 0; step <= 40; ++step) DriveTo(step);
  for (int step = 41; step <= 44; ++step) {
    estimate_ = estimate_ *
                odometry_.Advance(sensor::LaserScan{}, Between(OnRound(step - 1), OnRound(step)));
  }
  for (int step = 45; step <= 80; ++step) DriveTo(step, {0.01, 0, 0.01});
  ExpectNear(estimate_, Between(OnRound(0), OnRound(80)), 0.03, 0.01);
}

TEST_F(ScanOdometryInARoom, HonoursThePlaceOfTheLaserOnTheRobot) {
  laser_.robot_T_laser = {0.4, -0.1, 0.3};
  for (int step = 0; step <= 80; ++step) DriveTo(step, {0.01, 0.005, 0.01});
  ExpectNear(estimate_, Between(OnRound(0), OnRound(80)), 0.03, 0.01);
}

TEST_F(ScanOdometryInARoom, ForgetsOldMapsWithoutAJump) {
  ScanOdometry::Options options;
  options.map_scans = 4;  // a new map after every second scan entered
  odometry_ = ScanOdometry(options);
  for (int step = 0; step <= 160; ++step) {
    const SE2 motion = DriveTo(step, {0.01, 0, 0.005});
    if (step > 0) ExpectNear(motion, Between(OnRound(step - 1), OnRound(step)), 0.02, 0.01);
  }
}

TEST(ScanOdometry, TheWheelsSayHowFarItIsAlongACorridor) {
  ScanOdometry odometry({});
  SE2 estimate;
  for (int step = 0; step <= 40; ++step) {
    const SE2 pose{0.1 * step, 0, 0};
    const SE2 wheels = step == 0 ? SE2{} : SE2{0.1, 0.002, 0.003};
    estimate = estimate * odometry.Advance(synthetic::Scan(synthetic::Corridor(0.0), pose), wheels);
  }
  EXPECT_NEAR(estimate.x, 4.0, 0.12);
  EXPECT_NEAR(estimate.y, 0.0, 0.02);
  EXPECT_NEAR(estimate.theta, 0.0, 0.01);
}

}  // namespace
}  // namespace gmapping_spa::frontend
