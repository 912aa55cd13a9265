// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/rosbag/scan_beams.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "frontend/sensor/record_fields.h"

namespace gmapping_spa::rosbag {
namespace {

using sensor::BeamStatus;
using ::testing::ElementsAre;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr BeamStatus kHit = BeamStatus::kHit, kNone = BeamStatus::kNoReturn,
                     kInvalid = BeamStatus::kInvalid;

LaserScanMessage Message(const std::vector<double>& ranges_m) {
  LaserScanMessage scan;
  scan.angle_min_rad = -0.5;
  scan.angle_max_rad = 0.5;
  scan.angle_increment_rad = 0.25;
  scan.range_min_m = 0.25;
  scan.range_max_m = 8.0;
  scan.ranges_m = ranges_m;
  return scan;
}

std::vector<BeamStatus> StatusOf(const LaserScanMessage& scan,
                                 const sensor::LogOptions& options = {}) {
  std::vector<BeamStatus> status;
  for (const sensor::Beam& beam : BeamsOf(scan, options)) status.push_back(beam.status);
  return status;
}

TEST(ScanBeams, TurnClockwiseWhereTheIncrementIsNegative) {
  LaserScanMessage scan = Message({1.0, 2.0, 3.0});
  scan.angle_min_rad = 0.5;
  scan.angle_increment_rad = -0.5;
  const std::vector<sensor::Beam> beams = BeamsOf(scan, {});
  EXPECT_EQ(beams[2].angle_rad, -0.5);
  EXPECT_EQ(beams[2].range_m, 3.0);
}

TEST(ScanBeams, SpreadFromTheFirstAngleToTheLastWhereTheIncrementIsZero) {
  LaserScanMessage scan = Message({1.0, 2.0, 3.0});
  scan.angle_increment_rad = 0.0;
  EXPECT_EQ(BeamsOf(scan, {})[1].angle_rad, 0.0);
  scan.ranges_m = {1.0};
  EXPECT_EQ(BeamsOf(scan, {}).at(0).angle_rad, -0.5);
  scan.ranges_m = {1.0, 2.0};
  scan.angle_max_rad = scan.angle_min_rad;
  EXPECT_THROW(BeamsOf(scan, {}), sensor::MalformedRecord);
}

TEST(ScanBeams, HaveToBeThereAndWithinATurn) {
  LaserScanMessage scan = Message(std::vector<double>(361, 1.0));
  scan.angle_increment_rad = std::numbers::pi / 180.0;
  EXPECT_EQ(BeamsOf(scan, {}).size(), 361u);
  scan.angle_increment_rad = 1.0;  // degrees
  EXPECT_THROW(BeamsOf(scan, {}), sensor::MalformedRecord);
  EXPECT_THROW(BeamsOf(Message({}), {}), sensor::MalformedRecord);
}

TEST(ScanBeams, ReadingsAreWithinTheLimitsOfTheLaserAndOfTheOptions) {
  const LaserScanMessage scan = Message({0.125, 0.25, 0.5, 7.0, 8.0});
  EXPECT_THAT(StatusOf(scan), ElementsAre(kInvalid, kHit, kHit, kHit, kNone));
  EXPECT_THAT(StatusOf(scan, {.usable_range_m = 7.0, .range_min_m = 0.5}),
              ElementsAre(kInvalid, kInvalid, kHit, kNone, kNone));
  EXPECT_EQ(BeamsOf(scan, {}).back().range_m, 8.0);
}

TEST(ScanBeams, LimitsThatMakeNoSenseAreThoseOfTheOptions) {
  LaserScanMessage scan = Message({0.01, 0.125, 7.0, 9.0, 40.0, kInfinite, -kInfinite, kNoNumber});
  scan.angle_increment_rad = 0.125;
  for (const double range_min_m : {0.0, -1.0, 40.0, kInfinite, -kInfinite, kNoNumber}) {
    for (const double range_max_m : {0.0, 0.05, -1.0, kInfinite, -kInfinite, kNoNumber}) {
      scan.range_min_m = range_min_m;
      scan.range_max_m = range_max_m;
      EXPECT_THAT(StatusOf(scan),
                  ElementsAre(kInvalid, kHit, kHit, kHit, kNone, kNone, kInvalid, kInvalid))
          << range_min_m << " to " << range_max_m;
    }
  }
}

TEST(ScanBeams, SweepIsZeroWhereTheMessageDoesNotTellIt) {
  LaserScanMessage scan = Message({1.0, 2.0, 3.0});
  for (const double increment_s : {0.0, -0.1, kInfinite, -kInfinite, kNoNumber, 0.75}) {
    scan.time_increment_s = increment_s;
    EXPECT_EQ(SweepOf(scan), 0.0) << increment_s;
  }
  scan.time_increment_s = 0.5;
  EXPECT_EQ(SweepOf(scan), 1.0);
  scan.ranges_m = {};
  EXPECT_EQ(SweepOf(scan), 0.0);
}

}  // namespace
}  // namespace gmapping_spa::rosbag
