// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_density.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/frontend/lidar_odometry_drive.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

sensor::LaserScan ScanOf(int beams) {
  sensor::LaserScan scan;
  scan.beams.resize(beams);
  return scan;
}

TEST(ScanDensity, IsThePartOfADenseScanAndNeverMoreThanOne) {
  EXPECT_DOUBLE_EQ(ScanDensity(ScanOf(9)), 0.01);
  EXPECT_DOUBLE_EQ(ScanDensity(ScanOf(45)), 0.25);
  EXPECT_DOUBLE_EQ(ScanDensity(ScanOf(90)), 1.0);
  EXPECT_DOUBLE_EQ(ScanDensity(ScanOf(720)), 1.0);
}

TEST(ScanDensity, OfFilterUpdatesFallsMoreSlowly) {
  EXPECT_DOUBLE_EQ(UpdateDensity(ScanOf(90)), 1.0);
  EXPECT_NEAR(UpdateDensity(ScanOf(45)), std::pow(0.5, 1.5), 1e-12);
}

// A map of a scan each half metre would have walls with holes.
TEST(ScanDensity, FewBeamsFollowTheRobotInSpiteOfWheelsThatSlip) {
  const SE2 slip{0.02, 0.005, 0.01};
  for (const int beams : {18, 24, 36}) {
    Drive drive(synthetic::Room(), {.beams = beams});
    for (int step = 0; step <= 160; ++step) {
      drive.To(OnRound(step), {StepOfRound(step) * slip});
    }
    SCOPED_TRACE(beams);
    drive.ExpectIsWhereItIs(0.06, 0.03);
  }
}

}  // namespace
}  // namespace gmapping_spa::frontend
