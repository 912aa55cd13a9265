// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/seen_through.h"

#include <gtest/gtest.h>

#include "tests/frontend/room_map.h"

namespace gmapping_spa::scan_matching {
namespace {

using backend::SE2;

const SE2 kPose{0.4, -0.2, 0.3};

// Number of beams of a scan taken at kPose whose ranges were changed.
template <typename Change>
double Through(const Change& change) {
  sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), kPose);
  for (sensor::Beam& beam : scan.beams) change(&beam.range_m);
  return CountSeenThrough(synthetic::RoomMap(), MakeScanPoints(scan), kPose).all;
}

double AllBeams() {
  double weights = 0.0;
  for (const ScanPoint& point : MakeScanPoints(synthetic::Scan(synthetic::Room(), kPose))) {
    weights += point.weight;
  }
  return weights;
}

TEST(SeenThrough, BeamsThatEndAtTheirWallsPassThroughNone) {
  EXPECT_LT(Through([](double*) {}), 0.02 * AllBeams());
}

TEST(SeenThrough, WhatStandsBeforeTheWallsIsNothingSeenThrough) {
  EXPECT_EQ(Through([](double* range_m) { *range_m *= 0.5; }), 0.0);
}

TEST(SeenThrough, BeamsThatEndBehindTheirWallsAllPassThroughThem) {
  EXPECT_GT(Through([](double* range_m) { *range_m += 1.0; }), 0.95 * AllBeams());
}

TEST(SeenThrough, TellsWhetherBeamsEndWhereNoneHasBeen) {
  sensor::LaserScan scan = synthetic::Scan(synthetic::Room(), kPose);
  for (sensor::Beam& beam : scan.beams) beam.range_m += 20.0;
  const ScanPoints points = MakeScanPoints(scan);
  const SeenThrough through = CountSeenThrough(synthetic::RoomMap(), points, kPose);
  EXPECT_EQ(through.into_unseen, through.all);
  EXPECT_GT(through.all, 0.0);
}

TEST(SeenThrough, AScanWithoutHitsPassesThroughNothing) {
  EXPECT_EQ(CountSeenThrough(synthetic::RoomMap(), {}, kPose).all, 0.0);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
