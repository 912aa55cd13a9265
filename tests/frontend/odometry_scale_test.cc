// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/odometry_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "backend/counter_random.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// A robot that goes on by a decimeter and turns a little, over and over; scan matching is off by
// some millimeters.
class OdometryScaleOnADrive : public testing::Test {
 protected:
  // With odometry whose ways are `told` times as long. Returns how often another factor is proved.
  int Drive(int scans, double told) {
    int proved = 0;
    for (int k = 0; k < scans; ++k) {
      const SE2 step = Step();
      proved += scale_.Add(Told(step, told), Noisy(step)) ? 1 : 0;
    }
    return proved;
  }

  static SE2 Step() { return {0.1, 0.0, 0.02}; }
  static SE2 Told(const SE2& step, double told) {
    return {told * step.x, told * step.y, step.theta};
  }
  SE2 Noisy(const SE2& step) {
    return {step.x + 0.005 * random_.Gaussian(), step.y + 0.005 * random_.Gaussian(), step.theta};
  }

  OdometryScale scale_;
  backend::CounterRandom random_{5, 0};
};

TEST_F(OdometryScaleOnADrive, OtherUnitsAreFoundOnceAndTakenExactly) {
  const std::pair<double, std::string> units[] = {
      {0.3048, "feet"}, {0.0254, "inches"}, {0.01, "centimeters"}, {0.001, "millimeters"}};
  for (const auto& [meters, name] : units) {
    scale_ = {};
    EXPECT_EQ(Drive(100, 1.0 / meters), 1) << name;
    EXPECT_EQ(scale_.factor(), meters) << name;
    EXPECT_EQ(scale_.unit(), name);
  }
}

TEST_F(OdometryScaleOnADrive, AWrongNumberOfTicksIsFoundUpToNoise) {
  Drive(100, 0.5);
  EXPECT_NEAR(scale_.factor(), 2.0, 0.05);
  EXPECT_STREQ(scale_.unit(), "");
}

TEST_F(OdometryScaleOnADrive, WhatIsNearlyAUnitAtFirstBecomesOne) {
  EXPECT_EQ(Drive(60, 3.0), 1);
  EXPECT_STREQ(scale_.unit(), "");
  EXPECT_EQ(Drive(150, 3.28), 1);
  EXPECT_STREQ(scale_.unit(), "feet");
}

TEST_F(OdometryScaleOnADrive, WhatSlipExplainsIsLeftAlone) {
  for (const double told : {0.85, 1.0, 1.2}) {
    scale_ = {};
    EXPECT_EQ(Drive(300, told), 0) << told;
    EXPECT_EQ(scale_.factor(), 1.0) << told;
  }
}

TEST_F(OdometryScaleOnADrive, FewStretchesOrStretchesThatDisagreeProveNothing) {
  EXPECT_EQ(Drive(20, 3.28), 0);
  scale_ = {};
  for (int k = 0; k < 40; ++k) EXPECT_EQ(Drive(8, k % 2 == 0 ? 3.28 : 1.0), 0);
  EXPECT_EQ(scale_.factor(), 1.0);
}

TEST_F(OdometryScaleOnADrive, ASmallFactorTakesMoreStretchesThanAPlainOne) {
  EXPECT_EQ(Drive(50, 0.6), 0);
  EXPECT_EQ(Drive(60, 1.0), 0);
  scale_ = {};
  EXPECT_EQ(Drive(50, 0.3), 1);
  scale_ = {};
  EXPECT_EQ(Drive(120, 0.6), 1);
}

TEST_F(OdometryScaleOnADrive, WhatIsJustGrossIsNotTakenBackAndForth) {
  int proved = 0;
  for (int k = 0; k < 50; ++k) proved += Drive(20, k % 5 == 0 ? 1.36 : 1.28);
  EXPECT_LE(proved, 1);
}

TEST_F(OdometryScaleOnADrive, ANewFactorIsFoundAnewAndOneTakesItBack) {
  Drive(100, 100.0);
  EXPECT_EQ(Drive(200, 1.0), 1);
  EXPECT_EQ(scale_.factor(), 1.0);
}

TEST_F(OdometryScaleOnADrive, ScansThatTellNothingAndWheelsThatAreSilentTeachNothing) {
  for (int k = 0; k < 300; ++k) {
    if (k % 3 == 0) scale_.Skip();
    EXPECT_FALSE(scale_.Add(Told(Step(), 3.28), Noisy(Step())));
  }
  EXPECT_EQ(Drive(300, 0.0), 0);
  for (int k = 0; k < 300; ++k) EXPECT_FALSE(scale_.Add({0.3, 0, 0}, Noisy({})));  // stands still
  EXPECT_EQ(scale_.factor(), 1.0);
}

}  // namespace
}  // namespace gmapping_spa::frontend
