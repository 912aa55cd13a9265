// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/wheel_calibration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "backend/counter_random.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

constexpr int kSteps = 20;            // in a block
constexpr double kNoise_rad = 0.005;  // of a step
constexpr double kBlockVariance_rad2 = kSteps * kNoise_rad * kNoise_rad;

class WheelCalibrationOnADrive : public testing::Test {
 protected:
  // A block of 1 m and of turns to both sides, of which the wheels miss so much.
  void DriveBlock(double rad_per_m, double rad_per_rad) {
    ++block_;
    for (int step = 0; step < kSteps; ++step) {
      const SE2 wheels{1.0 / kSteps, 0.0, (block_ % 3 - 1) * 0.4 / kSteps};
      const double missing_rad = rad_per_m * wheels.x + rad_per_rad * wheels.theta;
      calibration_.Add(
          wheels, {wheels.x, 0.0, wheels.theta + missing_rad + kNoise_rad * random_.Gaussian()});
    }
    calibration_.Learn(kBlockVariance_rad2);
  }

  WheelCalibration calibration_;
  backend::CounterRandom random_{1, 0};
  int block_ = 0;
};

TEST_F(WheelCalibrationOnADrive, WhatIsMissingAllTheTimeIsLearnedAndAdded) {
  for (int k = 0; k < 150; ++k) DriveBlock(-0.05, 0.08);
  EXPECT_TRUE(calibration_.corrects());
  EXPECT_NEAR(calibration_.rad_per_m(), -0.05, 0.005);
  EXPECT_NEAR(calibration_.rad_per_rad(), 0.08, 0.02);
  const SE2 corrected = calibration_.Corrected({0.1, 0.01, 0.2});
  EXPECT_EQ(corrected.x, 0.1);
  EXPECT_EQ(corrected.y, 0.01);
  EXPECT_NEAR(corrected.theta, 0.2 - 0.05 * 0.1 + 0.08 * 0.2, 0.005);
}

TEST_F(WheelCalibrationOnADrive, InReverseItIsMissingTheOtherWay) {
  for (int k = 0; k < 50; ++k) DriveBlock(0.05, 0.0);
  EXPECT_GT(calibration_.Corrected({0.1, 0.0, 0.0}).theta, 0.003);
  EXPECT_LT(calibration_.Corrected({-0.1, 0.0, 0.0}).theta, -0.003);
}

TEST_F(WheelCalibrationOnADrive, NoiseFeignsNothing) {
  for (int k = 0; k < 300; ++k) {
    DriveBlock(0.0, 0.0);
    EXPECT_LT(std::abs(calibration_.rad_per_m()), 0.005);
    EXPECT_LT(std::abs(calibration_.rad_per_rad()), 0.01);
  }
  EXPECT_FALSE(calibration_.corrects());
}

TEST_F(WheelCalibrationOnADrive, ASlipTeachesNothing) {
  for (int k = 0; k < 50; ++k) DriveBlock(0.0, 0.0);
  calibration_.Add({0.05, 0.0, 0.0}, {0.05, 0.0, 0.5});
  DriveBlock(0.0, 0.0);
  EXPECT_FALSE(calibration_.corrects());
}

TEST_F(WheelCalibrationOnADrive, WhatChangesIsLearnedAnew) {
  for (int k = 0; k < 100; ++k) DriveBlock(0.05, 0.0);
  for (int k = 0; k < 400; ++k) DriveBlock(-0.05, 0.0);
  EXPECT_NEAR(calibration_.rad_per_m(), -0.05, 0.008);
}

}  // namespace
}  // namespace gmapping_spa::frontend
