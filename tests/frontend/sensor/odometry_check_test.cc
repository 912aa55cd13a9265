// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/odometry_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace gmapping_spa::sensor {
namespace {

using backend::SE2;

// A scan that differs from every other one with another `range_m`.
LaserScan ScanAt(double stamp_s, const SE2& odom_T_robot, double range_m) {
  LaserScan scan;
  scan.stamp_s = stamp_s;
  scan.odom_T_robot = odom_T_robot;
  scan.beams = {{-0.5, range_m, BeamStatus::kHit}, {0.5, 40.0, BeamStatus::kNoReturn}};
  return scan;
}

class OdometryCheckTest : public ::testing::Test {
 protected:
  OdometryCheck::Step Check(double stamp_s, const SE2& odom_T_robot) {
    return check_.Check(ScanAt(stamp_s, odom_T_robot, range_m_ += 0.01));
  }
  OdometryFault FaultOf(double stamp_s, const SE2& odom_T_robot) {
    return Check(stamp_s, odom_T_robot).fault;
  }
  // Straight ahead at 0.5 m/s, five scans a second, from (10, 0, 0) on; returns the last stamp.
  double Drive(int scans) {
    for (int i = 0; i < scans; ++i) Check(0.2 * i, {10.0 + 0.1 * i, 0, 0});
    return 0.2 * (scans - 1);
  }
  void ExpectNothingKnown(const OdometryCheck::Step& step, OdometryFault fault) {
    EXPECT_EQ(step.fault, fault);
    EXPECT_EQ(step.motion, SE2{});
  }

  OdometryCheck check_{{}};
  double range_m_ = 1.0;
};

TEST_F(OdometryCheckTest, GivesTheMotionInTheFrameOfTheRobot) {
  ExpectNothingKnown(Check(0.0, {1, 2, M_PI / 2}), OdometryFault::kFirst);
  const OdometryCheck::Step step = Check(0.2, {1, 2.1, M_PI / 2 + 0.1});
  EXPECT_EQ(step.fault, OdometryFault::kNone);
  EXPECT_NEAR(step.motion.x, 0.1, 1e-12);
  EXPECT_NEAR(step.motion.y, 0.0, 1e-12);
  EXPECT_NEAR(step.motion.theta, 0.1, 1e-12);
}

TEST_F(OdometryCheckTest, AStepFasterThanARobotIsNoInformationAndTheNextOneCountsAgain) {
  Check(0.0, {10, 0, 0});
  ExpectNothingKnown(Check(0.2, {11.1, 0, 0}), OdometryFault::kImpossible);
  EXPECT_NEAR(Check(0.4, {11.2, 0, 0}).motion.x, 0.1, 1e-12);
  ExpectNothingKnown(Check(0.6, {11.2, 0, 1.3}), OdometryFault::kImpossible);
  EXPECT_EQ(FaultOf(0.8, {11.2, 0, 1.35}), OdometryFault::kNone);
}

TEST_F(OdometryCheckTest, ALongTimeAllowsALongStep) {
  Check(0.0, {10, 0, 0});
  EXPECT_EQ(FaultOf(10.0, {40, 0, 2}), OdometryFault::kNone);
}

TEST_F(OdometryCheckTest, LimitsAreThoseOfTheOptions) {
  check_ = OdometryCheck({.max_speed_m_s = 1.0, .max_turn_rad_s = 1.0});
  Check(0.0, {10, 0, 0});
  EXPECT_EQ(FaultOf(0.5, {10.4, 0, 0.4}), OdometryFault::kNone);
  EXPECT_EQ(FaultOf(1.0, {11.0, 0, 0.4}), OdometryFault::kImpossible);
  EXPECT_EQ(FaultOf(1.5, {11.0, 0, 1.0}), OdometryFault::kImpossible);
}

TEST_F(OdometryCheckTest, JitterOfStampsMakesNoStepImpossible) {
  // Two scans a second at 2 m/s, but every other stamp comes a millisecond after the one before,
  // every tenth goes back.
  for (int i = 0; i < 100; ++i) {
    double stamp_s = i % 2 == 0 ? 0.5 * i : 0.5 * (i - 1) + 1e-3;
    if (i % 10 == 9) stamp_s -= 1.0;
    const OdometryFault fault = FaultOf(stamp_s, {10.0 + i, 0, 0});
    if (i > 10) {  // the usual time between scans is known by then
      EXPECT_EQ(fault, OdometryFault::kNone) << i;
    }
  }
}

TEST_F(OdometryCheckTest, ABunchOfScansThatWereWaitingMakesNoStepImpossible) {
  // Five scans a second at 1 m/s; then many that waited come at once, the last two in wrong order.
  double stamp_s = 0.0, x = 10.0;
  for (int i = 0; i < 50; ++i) Check(stamp_s += 0.2, {x += 0.2, 0, 0});
  stamp_s += 4.0;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(FaultOf(stamp_s += 0.002, {x += 0.2, 0, 0}), OdometryFault::kNone) << i;
  }
  EXPECT_EQ(FaultOf(stamp_s += 0.002, {x - 0.8, 0, 0}), OdometryFault::kNone);
}

TEST_F(OdometryCheckTest, ReadingsThatAreNotFiniteSayNothingAboutEitherNeighbor) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Check(0.0, {nan, 0, 0});
  ExpectNothingKnown(Check(0.2, {1, 0, 0}), OdometryFault::kImpossible);
  ExpectNothingKnown(Check(0.4, {1, nan, 0}), OdometryFault::kImpossible);
  ExpectNothingKnown(Check(0.6, {1.1, 0, 0}), OdometryFault::kImpossible);
  EXPECT_EQ(FaultOf(0.8, {1.2, 0, 0}), OdometryFault::kNone);
}

TEST_F(OdometryCheckTest, AJumpToZeroOrToTheFirstReadingIsARestart) {
  double stamp_s = Drive(20);
  ExpectNothingKnown(Check(stamp_s += 0.2, {0, 0, 0}), OdometryFault::kRestart);
  EXPECT_NEAR(Check(stamp_s += 0.2, {0.1, 0, 0}).motion.x, 0.1, 1e-12);
  for (int i = 2; i < 40; ++i) Check(stamp_s += 0.2, {0.1 * i, 0, 0});
  ExpectNothingKnown(Check(stamp_s += 0.2, {10.02, 0, 0}), OdometryFault::kRestart);
}

TEST_F(OdometryCheckTest, ARestartNearTheStartIsFoundThoughARobotCouldDriveThatFar) {
  for (int i = 0; i < 5; ++i) Check(0.2 * i, {0.1 * i, 0, 0});
  ExpectNothingKnown(Check(1.0, {0, 0, 0}), OdometryFault::kRestart);
}

TEST_F(OdometryCheckTest, DrivingBackToTheStartIsNoRestart) {
  for (int i = 0; i <= 40; ++i) {
    const int tenths = i <= 20 ? i : 40 - i;
    EXPECT_NE(FaultOf(0.2 * i, {0.16 * tenths, 0, 0}), OdometryFault::kRestart) << i;
  }
}

TEST_F(OdometryCheckTest, TheSameReadingIsSilenceOrAStop) {
  Check(0.0, {10, 0, 0});
  ExpectNothingKnown(Check(0.2, {10, 0, 0}), OdometryFault::kUnchanged);
}

TEST_F(OdometryCheckTest, RepeatedRangesAreAFaultOnlyWhereTheWheelsMoved) {
  check_.Check(ScanAt(0.0, {10, 0, 0}, 3.0));
  EXPECT_EQ(check_.Check(ScanAt(0.2, {10, 0, 0}, 3.0)).fault, OdometryFault::kUnchanged);
  EXPECT_EQ(check_.Check(ScanAt(0.4, {10.0001, 0, 0}, 3.0)).fault, OdometryFault::kNone);
  const OdometryCheck::Step moved = check_.Check(ScanAt(0.6, {10.1, 0, 0}, 3.0));
  EXPECT_EQ(moved.fault, OdometryFault::kRepeatedScan);
  EXPECT_NEAR(moved.motion.x, 0.0999, 1e-12) << "what the wheels say is kept";
  EXPECT_EQ(check_.Check(ScanAt(0.8, {10.2, 0, 0}, 3.1)).fault, OdometryFault::kNone);
}

TEST_F(OdometryCheckTest, ScansThatHitNothingAreNoRepetition) {
  LaserScan scan = ScanAt(0.0, {10, 0, 0}, 40.0);
  scan.beams[0].status = BeamStatus::kNoReturn;
  check_.Check(scan);
  scan.odom_T_robot.x += 0.1;
  EXPECT_EQ(check_.Check(scan).fault, OdometryFault::kNone);
}

TEST_F(OdometryCheckTest, WithoutOdometryAtEitherEndNothingIsKnown) {
  LaserScan scan = ScanAt(0.0, {}, 1.0);
  scan.has_odometry = false;
  ExpectNothingKnown(check_.Check(scan), OdometryFault::kMissing);
  ExpectNothingKnown(check_.Check(scan), OdometryFault::kMissing);
  ExpectNothingKnown(Check(0.4, {10, 0, 0}), OdometryFault::kMissing);
  EXPECT_EQ(FaultOf(0.6, {10.1, 0, 0}), OdometryFault::kNone);
}

TEST(OdometryFaultName, EachHasItsOwn) {
  std::set<std::string> names;
  for (int fault = 0; fault <= static_cast<int>(OdometryFault::kMissing); ++fault) {
    names.insert(OdometryFaultName(static_cast<OdometryFault>(fault)));
  }
  EXPECT_EQ(names.size(), 7u);
  EXPECT_FALSE(names.contains("unknown"));
}

TEST(OdometryFaultMessage, IsEmptyWhereThereIsNothingToReport) {
  for (int k = 0; k <= static_cast<int>(OdometryFault::kMissing); ++k) {
    const auto fault = static_cast<OdometryFault>(k);
    const bool nothing = fault == OdometryFault::kNone || fault == OdometryFault::kFirst ||
                         fault == OdometryFault::kUnchanged;
    EXPECT_EQ(std::string(OdometryFaultMessage(fault)).empty(), nothing) << k;
  }
}

TEST_F(OdometryCheckTest, WaysAreScaledBeforeTheyAreJudgedAndToldAsTheyAre) {
  check_.set_way_factor(0.001);
  Check(0.0, {1000, 0, 0});
  const OdometryCheck::Step step = Check(0.2, {1100, 50, 0.1});
  EXPECT_EQ(step.fault, OdometryFault::kNone);
  EXPECT_EQ(step.motion, (SE2{0.1, 0.05, 0.1}));
  EXPECT_EQ(step.told, (SE2{100, 50, 0.1}));
  const OdometryCheck::Step jump = Check(0.4, {9100, 50, 0.1});
  ExpectNothingKnown(jump, OdometryFault::kImpossible);
  EXPECT_TRUE(jump.told);
  EXPECT_EQ(Check(0.6, {9100, 50, 0.1}).told, SE2{});
}

}  // namespace
}  // namespace gmapping_spa::sensor
