// SPDX-License-Identifier: BSD-3-Clause
// A robot whose scans fit nothing that it has seen, or only little of it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/frontend/lidar_odometry_drive.h"

namespace gmapping_spa::frontend {
namespace {

using backend::SE2;

// Once around Room() with exact wheels, then on with scans as `change` makes them of what is there.
// Returns after how many of at most `scans` a new piece began; zero: none did.
template <typename Change>
int ScansUpToANewPiece(int scans, Drive* drive, const Change& change) {
  for (int step = 0; step <= 80; ++step) drive->To(OnRound(step));
  for (int k = 1; k <= scans; ++k) {
    sensor::LaserScan scan = drive->ScanAt(OnRound(80 + k));
    change(&scan);
    const ScanMotion motion = drive->Take(scan, OnRound(80 + k), {StepOfRound(80 + k)});
    if (motion.new_piece_scans > 0) return k;
    EXPECT_FALSE(motion.matched) << k;
  }
  return 0;
}

// Walls of a place that is larger all around.
void Enlarge(sensor::LaserScan* scan) {
  for (sensor::Beam& beam : scan->beams) beam.range_m = 1.7 * beam.range_m + 0.5;
}

// A cover that goes along with the robot.
void Cover(sensor::LaserScan* scan) {
  for (sensor::Beam& beam : scan->beams) beam.range_m = std::min(beam.range_m, 0.6);
}

TEST(LidarOdometryLost, ScansThatSeeThroughWallsBeginANewPieceAfterASecond) {
  Drive drive(synthetic::Room());
  const int scans = ScansUpToANewPiece(60, &drive, Enlarge);
  EXPECT_GE(scans, 10);
  EXPECT_LE(scans, 20);
}

TEST(LidarOdometryLost, WhatHidesTheWallsBeginsNoneForTenSeconds) {
  Drive drive(synthetic::Room());
  EXPECT_EQ(ScansUpToANewPiece(90, &drive, Cover), 0);
}

TEST(LidarOdometryLost, MeanwhileThePoseIsThatOfTheWheelsAndTheMapStaysAsItWas) {
  Drive drive(synthetic::Room());
  ScansUpToANewPiece(20, &drive, Cover);
  drive.ExpectIsWhereItIs(0.05, 0.02);
  EXPECT_TRUE(drive.To(OnRound(101)).matched);
  drive.ExpectIsWhereItIs(0.03, 0.02);
}

// Farther than a robot gets from one scan to the next: what it may have done while covered adds up.
TEST(LidarOdometryLost, ARobotThatSlipsWhileItIsCoveredIsFoundAgain) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 80; ++step) drive.To(OnRound(step));
  const SE2 slip{0.9, 0.3, 1.2};
  for (int k = 1; k <= 5; ++k) {
    const SE2 pose = k < 3 ? OnRound(80 + k) : OnRound(80 + k) * slip;
    sensor::LaserScan scan = drive.ScanAt(pose);
    Cover(&scan);
    drive.Take(scan, pose, {StepOfRound(80 + k)});
  }
  EXPECT_TRUE(drive.To(OnRound(86) * slip, {StepOfRound(86)}).matched);
  drive.ExpectIsWhereItIs(0.05, 0.03);
}

// Of a scan half a meter from where the wheels lead: whether it is taken to be there, when so many
// of ten beams see farther than there.
bool IsFoundAside(int of_ten, const SE2& told) {
  Drive drive(synthetic::Room());
  for (int step = 0; step <= 80; ++step) drive.To(OnRound(step));
  const SE2 aside = OnRound(81) * SE2{0.4, 0.3, 0.5};
  sensor::LaserScan scan = drive.ScanAt(aside);
  for (std::size_t k = 0; k < scan.beams.size(); ++k) {
    if (static_cast<int>(k / 9 * 7 % 10) < of_ten) scan.beams[k].range_m += 1.5;
  }
  return drive.Take(scan, aside, {told}).matched;
}

TEST(LidarOdometryLost, WhatFitsInPartIsAnotherPlaceUnlessSomethingLeadsThere) {
  const SE2 there = StepOfRound(81) * SE2{0.4, 0.3, 0.5};
  EXPECT_TRUE(IsFoundAside(2, StepOfRound(81)));
  EXPECT_FALSE(IsFoundAside(4, StepOfRound(81)));
  EXPECT_TRUE(IsFoundAside(4, there));
}

// Nine beams are too few for the robot to be lost by them.
TEST(LidarOdometryLost, FewBeamsThatFitBadlyWaitForTheNextOnes) {
  Drive drive(synthetic::Room(), {.beams = 9});
  for (int step = 0; step <= 80; ++step) drive.To(OnRound(step));
  for (int k = 1; k <= 4; ++k) {
    sensor::LaserScan scan = drive.ScanAt(OnRound(80 + k));
    Cover(&scan);
    const ScanMotion motion = drive.Take(scan, OnRound(80 + k), {StepOfRound(80 + k)});
    EXPECT_EQ(motion.matched, k == 4) << k;  // by then the place has changed
  }
}

}  // namespace
}  // namespace gmapping_spa::frontend
