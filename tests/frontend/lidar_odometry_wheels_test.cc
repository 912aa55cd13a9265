// SPDX-License-Identifier: BSD-3-Clause
// Wheels that are wrong, late, silent or restarted.
#include <gtest/gtest.h>

#include <vector>

#include "tests/frontend/lidar_odometry_drive.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;
using sensor::OdometryFault;

constexpr Wheels kSilent{{}, OdometryFault::kUnchanged};

class LidarOdometryWithWheels : public testing::Test {
 protected:
  // Steps up to that one, with exact wheels.
  void DriveUpTo(int last) {
    while (step_ <= last) {
      drive_.To(OnRound(step_), {StepOfRound(step_)});
      ++step_;
    }
  }

  // The next step.
  ScanMotion Step(const Wheels& wheels) {
    const ScanMotion motion = drive_.To(OnRound(step_), wheels);
    ++step_;
    return motion;
  }
  SE2 NextStep() const { return StepOfRound(step_); }

  void ExpectIsWhereItIs() const { drive_.ExpectIsWhereItIs(0.03, 0.01); }

  Drive drive_{synthetic::Room()};
  int step_ = 0;
};

TEST_F(LidarOdometryWithWheels, AJumpOfTheHeadingIsRejected) {
  DriveUpTo(30);
  for (const double jump_deg : {15.0, -20.0, 30.0, -40.0, 50.0, -60.0, 60.0}) {
    const SE2 truth = NextStep();
    const ScanMotion motion = Step({truth * SE2{0, 0, jump_deg * kDeg}});
    EXPECT_TRUE(motion.wheels_rejected) << jump_deg;
    ExpectNear(motion.motion, truth, 0.03, 0.02);
    DriveUpTo(step_ + 10);
  }
  ExpectIsWhereItIs();
}

TEST_F(LidarOdometryWithWheels, AJumpOfHalfAMetreIsRejected) {
  DriveUpTo(30);
  for (const SE2 jump : {SE2{0.5, 0, 0}, SE2{-0.5, 0, 0.5}, SE2{0.1, 0.5, -0.5}, SE2{0, -0.5, 0}}) {
    const SE2 truth = NextStep();
    const ScanMotion motion = Step({truth * jump});
    EXPECT_TRUE(motion.wheels_rejected) << jump.x << ' ' << jump.y;
    ExpectNear(motion.motion, truth, 0.03, 0.02);
    DriveUpTo(step_ + 3);
  }
  ExpectIsWhereItIs();
}

TEST_F(LidarOdometryWithWheels, JumpsOfScanAfterScanAreRejected) {
  DriveUpTo(30);
  for (const SE2 jump : {SE2{0.25, 0, 0.3}, SE2{-0.2, 0.2, -0.3}, SE2{0, -0.25, 0.35}}) {
    Step({NextStep() * jump});
  }
  ExpectIsWhereItIs();
}

TEST_F(LidarOdometryWithWheels, SilentFromTheStartAreNotBelieved) {
  Step({});
  for (int step = 1; step <= 160; ++step) Step(kSilent);
  ExpectIsWhereItIs();
}

TEST_F(LidarOdometryWithWheels, SilentFromTheMiddleAreNotBelieved) {
  DriveUpTo(40);
  int said_so = 0;
  while (step_ <= 160) said_so += Step(kSilent).wheels_silent ? 1 : 0;
  ExpectIsWhereItIs();
  EXPECT_GT(said_so, 100);
}

TEST_F(LidarOdometryWithWheels, SilentForAWhileAreBelievedAfterwards) {
  DriveUpTo(40);
  while (step_ <= 80) Step(kSilent);
  int rejected = 0;
  while (step_ <= 120) {
    const ScanMotion motion = Step({NextStep()});
    EXPECT_FALSE(motion.wheels_silent) << step_;
    rejected += motion.wheels_rejected ? 1 : 0;
  }
  EXPECT_EQ(rejected, 0);
  ExpectIsWhereItIs();
}

TEST_F(LidarOdometryWithWheels, StandingStillIsNoSilence) {
  DriveUpTo(40);
  for (int i = 0; i < 30; ++i) {
    const ScanMotion motion = drive_.To(OnRound(40), kSilent);
    EXPECT_FALSE(motion.wheels_silent) << i;
    if (i > 2) ExpectNear(motion.motion, {}, 0.01, 0.005);
  }
  drive_.ExpectIsWhereItIs(0.02, 0.01);
}

TEST_F(LidarOdometryWithWheels, ThatSayNothingForFourScansAndThenAllAtOnceDoNoHarm) {
  DriveUpTo(30);
  for (int time = 0; time < 5; ++time) {
    SE2 held_back;
    for (int i = 0; i < 4; ++i) {
      held_back = held_back * NextStep();
      Step(kSilent);
    }
    held_back = held_back * NextStep();
    Step({held_back});
    DriveUpTo(step_ + 5);
  }
  ExpectIsWhereItIs();
}

TEST_F(LidarOdometryWithWheels, ThatAreTwoScansLateDoNoHarm) {
  // A robot that stops, turns and goes on again: only then does a delay matter.
  const auto pose = [](int step) {
    const double t = 0.1 * step;
    return SE2{0.8 * std::sin(0.9 * t), 0.5 * std::sin(1.7 * t), 1.2 * std::sin(1.1 * t)};
  };
  const auto motion = [&](int step) {
    return step <= 0 ? SE2{} : Between(pose(step - 1), pose(step));
  };
  for (int step = 0; step <= 200; ++step) drive_.To(pose(step), {motion(step - 2)});
  ExpectIsWhereItIs();
}

TEST_F(LidarOdometryWithWheels, ARestartDoesNoHarm) {
  DriveUpTo(30);
  Step({{}, OdometryFault::kRestart});
  DriveUpTo(60);
  Step({{}, OdometryFault::kImpossible});
  DriveUpTo(80);
  ExpectIsWhereItIs();
}

TEST_F(LidarOdometryWithWheels, AreNotNeeded) {
  Step({});
  while (step_ <= 160) Step({{}, OdometryFault::kMissing});
  ExpectIsWhereItIs();
}

}  // namespace
}  // namespace gmapping_spa::frontend
