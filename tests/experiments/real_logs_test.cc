// SPDX-License-Identifier: BSD-3-Clause
// Our best plain particle filter (gmapping_plus.flags) on whole logs of real buildings. Minutes
// each: label "long".
#include "tests/experiments/real_logs.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "frontend/map/map_server_io.h"

namespace gmapping_spa {
namespace {

constexpr char kPlus[] = "gmapping_plus.flags";

// The bounds are what the original GMapping reaches on the same logs. One seed, so that the tests
// end soon, and on intel half of its particles; the published figures are of five.
TEST_F(RealLogs, IntelIsAsGoodAsTheOriginal) {
  if (!HaveData("intel")) GTEST_SKIP() << "no real data";
  EXPECT_LE(Errors("intel", kPlus, 1, {"--particles=15"}).at(0), 0.039);
}

TEST_F(RealLogs, AcesIsAsGoodAsTheOriginal) {
  if (!HaveData("aces")) GTEST_SKIP() << "no real data";
  EXPECT_LE(Errors("aces", kPlus, 1, {}).at(0), 0.058);
}

TEST_F(RealLogs, MitKillianRunsThroughAndItsMapGrows) {
  if (!HaveData("mit-killian")) GTEST_SKIP() << "no real data";
  ASSERT_NO_FATAL_FAILURE(Slam("mit-killian", kPlus, {"--particles=5"}));  // fewer, to save time
  EXPECT_THAT(Trajectory(), ::testing::SizeIs(17480));
  const map::TrinaryMap map = map::ReadMap(folder_.Path("map.yaml"));
  EXPECT_GT(std::max(map.width, map.height) * map.resolution_m, 150.0);
}

}  // namespace
}  // namespace gmapping_spa
