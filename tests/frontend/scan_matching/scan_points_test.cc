#include "frontend/scan_matching/scan_points.h"

#include <gtest/gtest.h>

#include <numbers>

namespace gmapping_spa::scan_matching {
namespace {

using sensor::BeamStatus;

constexpr double kQuarterTurn = std::numbers::pi / 2;

TEST(MakeScanPoints, KeepsTheHitsInTheirOrder) {
  sensor::LaserScan scan;
  scan.beams = {{0.0, 1.0, BeamStatus::kHit},
                {0.0, 9.0, BeamStatus::kNoReturn},
                {0.0, 0.0, BeamStatus::kInvalid},
                {0.0, 2.0, BeamStatus::kHit}};
  const ScanPoints points = MakeScanPoints(scan);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].x_m, 1.0);
  EXPECT_EQ(points[1].x_m, 2.0);
}

TEST(MakeScanPoints, AreInTheRobotFrameAndPointBackToTheLaser) {
  sensor::LaserScan scan;
  scan.odom_T_robot = {100, 200, 1};  // must not matter
  scan.robot_T_laser = {0.3, -0.1, kQuarterTurn};
  scan.beams = {{0.0, 2.0, BeamStatus::kHit}, {kQuarterTurn, 3.0, BeamStatus::kHit}};
  const ScanPoints points = MakeScanPoints(scan);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(points[0].x_m, 0.3, 1e-12);
  EXPECT_NEAR(points[0].y_m, 1.9, 1e-12);
  EXPECT_NEAR(points[0].back_x, 0.0, 1e-12);
  EXPECT_NEAR(points[0].back_y, -1.0, 1e-12);
  EXPECT_NEAR(points[1].x_m, -2.7, 1e-12);
  EXPECT_NEAR(points[1].y_m, -0.1, 1e-12);
  EXPECT_NEAR(points[1].back_x, 1.0, 1e-12);
  EXPECT_NEAR(points[1].back_y, 0.0, 1e-12);
}

TEST(MakeScanPoints, OfAScanWithoutHitsAreNone) {
  sensor::LaserScan scan;
  scan.beams = {{0.0, 9.0, BeamStatus::kNoReturn}};
  EXPECT_TRUE(MakeScanPoints(scan).empty());
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
