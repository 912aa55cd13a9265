// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/stand_still.h"

#include <gtest/gtest.h>

#include <vector>

namespace gmapping_spa::frontend {
namespace {

// All beams see something at 5 m, the first `moved` of them so much farther off.
sensor::LaserScan Scan(int moved, double farther_m) {
  sensor::LaserScan scan;
  for (int k = 0; k < 20; ++k) {
    scan.beams.push_back({.angle_rad = 0.1 * k,
                          .range_m = k < moved ? 5.0 + farther_m : 5.0,
                          .status = sensor::BeamStatus::kHit});
  }
  return scan;
}

TEST(StandStill, ScansThatChangeByAndByContradictIt) {
  StandStill stand_still;
  EXPECT_FALSE(stand_still.IsContradicted(Scan(0, 0.0), false));
  EXPECT_FALSE(stand_still.IsContradicted(Scan(20, 0.2), true));
  EXPECT_FALSE(stand_still.IsContradicted(Scan(20, 0.4), true));
  EXPECT_TRUE(stand_still.IsContradicted(Scan(20, 0.6), true));
}

TEST(StandStill, NoiseAndPeopleDoNot) {
  StandStill stand_still;
  stand_still.IsContradicted(Scan(0, 0.0), false);
  EXPECT_FALSE(stand_still.IsContradicted(Scan(20, 0.1), true));
  EXPECT_FALSE(stand_still.IsContradicted(Scan(4, 3.0), true));
  EXPECT_TRUE(stand_still.IsContradicted(Scan(5, 3.0), true));
}

TEST(StandStill, BeginsAnewWhenTheOdometryMoves) {
  StandStill stand_still;
  stand_still.IsContradicted(Scan(0, 0.0), false);
  EXPECT_FALSE(stand_still.IsContradicted(Scan(20, 0.6), false));
  EXPECT_FALSE(stand_still.IsContradicted(Scan(20, 0.7), true));
}

TEST(StandStill, OtherBeamsAreNotCompared) {
  StandStill stand_still;
  stand_still.IsContradicted(Scan(0, 0.0), false);
  sensor::LaserScan fewer = Scan(20, 2.0);
  fewer.beams.resize(10);
  EXPECT_FALSE(stand_still.IsContradicted(fewer, true));
}

}  // namespace
}  // namespace gmapping_spa::frontend
