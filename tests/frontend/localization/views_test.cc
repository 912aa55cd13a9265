// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/localization/views.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gmapping_spa::localization {
namespace {

using backend::SE2;

sensor::LaserScan WallAhead(double range_m) {
  sensor::LaserScan scan;
  scan.beams = {{0.0, range_m, sensor::BeamStatus::kHit}};
  return scan;
}

TEST(Views, TheFirstScanIsOneAndThenEachAfterSomeMotion) {
  Views views({.every_m = 0.3, .every_rad = 0.2});
  EXPECT_TRUE(views.Add(WallAhead(9), {}));
  EXPECT_FALSE(views.Add(WallAhead(9), {0.2, 0, 0}));
  EXPECT_TRUE(views.Add(WallAhead(9), {0.2, 0, 0}));
  EXPECT_FALSE(views.Add(WallAhead(9), {0, 0, 0.15}));
  EXPECT_TRUE(views.Add(WallAhead(9), {0, 0, 0.15}));
  EXPECT_EQ(views.views().size(), 3u);
}

TEST(Views, ThoseOfLongAgoAreForgotten) {
  Views views({.every_m = 0.3, .reach_m = 2.0, .max_views = 100});
  for (int k = 0; k < 50; ++k) views.Add(WallAhead(9), {0.5, 0, 0});
  EXPECT_EQ(views.views().size(), 5u);  // of 0, 0.5, ... 2 m
}

TEST(Views, ARobotThatTurnsOnTheSpotKeepsSoManyAndNoMore) {
  Views views({.every_rad = 0.3, .max_views = 7});
  for (int k = 0; k < 50; ++k) views.Add(WallAhead(9), {0, 0, 0.4});
  EXPECT_EQ(views.views().size(), 7u);
}

TEST(Views, JoinedTheySayWhereThingsAreFromTheRobotAsItIsNow) {
  Views views({});
  views.Add(WallAhead(5.0), {});
  views.Add(WallAhead(4.0), {1.0, 0, 0});
  views.Add(WallAhead(7.0), {0, 0, 0.5});
  const scan_matching::ScanPoints joined = views.Joined(0.01);
  ASSERT_EQ(joined.size(), 2u);  // the first two are the same
  EXPECT_NEAR(joined[0].x_m, 4.0 * std::cos(0.5), 1e-9);
  EXPECT_NEAR(joined[0].y_m, -4.0 * std::sin(0.5), 1e-9);
  EXPECT_NEAR(joined[1].x_m, 7.0, 1e-9);
}

}  // namespace
}  // namespace gmapping_spa::localization
