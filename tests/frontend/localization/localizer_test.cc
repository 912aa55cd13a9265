// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/localization/localizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "tests/frontend/localization/localize.h"

namespace gmapping_spa::localization {
namespace {

using backend::SE2;

TEST(Localizer, FindsARobotOnItsFirstMetersAnywhereInTheHall) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  for (double from_m = 0.0; from_m < 46.0; from_m += 3.7) {
    const auto scans = synthetic::Driven(synthetic::Hall(), from_m, from_m + 3.5);
    const Outcome outcome = Localize(map, scans);
    ASSERT_TRUE(outcome.located) << from_m;
    const SE2 off = Between(scans[outcome.scan].odom_T_robot, outcome.located->map_T_robot);
    EXPECT_LT(off.translation().norm(), 0.1) << from_m;
    EXPECT_LT(std::abs(off.theta), 0.02) << from_m;
  }
}

TEST(Localizer, NeverFindsARobotWhereTheMapEnds) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall(), 0.0, 5.0);
  const Outcome outcome = Localize(map, synthetic::Driven(synthetic::Hall(), 24.0, 30.0));
  if (!outcome.located) return;  // what it sees of the known part may do
  EXPECT_LT((outcome.located->map_T_robot.translation() -
             synthetic::OnRing(24.0 + 0.1 * static_cast<double>(outcome.scan)).translation())
                .norm(),
            0.2);
}

TEST(Localizer, RestartedItKnowsNothingOfBefore) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  Localizer localizer({}, &map);
  // In another building, and then carried into the hall.
  const auto elsewhere = synthetic::Driven(synthetic::Ring(), 0.0, 4.0);
  for (const sensor::LaserScan& scan : elsewhere) localizer.AddScan(scan, {0.1, 0, 0});
  localizer.Restart();
  const auto scans = synthetic::Driven(synthetic::Hall(), 12.0, 13.0);
  std::optional<Located> located;
  for (std::size_t k = 0; k < scans.size() && !located; ++k) {
    located =
        localizer
            .AddScan(scans[k],
                     k > 0 ? Between(scans[k - 1].odom_T_robot, scans[k].odom_T_robot) : SE2{})
            .located;
  }
  ASSERT_TRUE(located);
  EXPECT_LT((located->map_T_robot.translation() - scans.back().odom_T_robot.translation()).norm(),
            1.1);
}

// Found in the hall, then carried into another building behind its back.
TEST(Localizer, WhatIsSeenAfterwardsMayTakeItBack) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  Localizer localizer({}, &map);
  const auto scans = synthetic::Driven(synthetic::Hall(), 12.0, 14.0);
  for (std::size_t k = 0; k < scans.size() && localizer.searches(); ++k) {
    localizer.AddScan(scans[k],
                      k > 0 ? Between(scans[k - 1].odom_T_robot, scans[k].odom_T_robot) : SE2{});
  }
  ASSERT_FALSE(localizer.searches());
  bool taken_back = false;
  for (const sensor::LaserScan& scan : synthetic::Driven(synthetic::Ring(), 0.0, 4.0)) {
    taken_back = taken_back || localizer.AddScan(scan, {0.1, 0, 0}).taken_back;
  }
  EXPECT_TRUE(taken_back);
  EXPECT_TRUE(localizer.searches());
}

TEST(Localizer, ARobotThatDrivesOnWhereItWasFoundIsNotTakenBack) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  Localizer localizer({}, &map);
  const auto scans = synthetic::Driven(synthetic::Hall(), 12.0, 24.0);
  int located = 0;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const Localizer::Outcome outcome = localizer.AddScan(
        scans[k], k > 0 ? Between(scans[k - 1].odom_T_robot, scans[k].odom_T_robot) : SE2{});
    located += outcome.located ? 1 : 0;
    EXPECT_FALSE(outcome.taken_back) << k;
  }
  EXPECT_EQ(located, 1);
}

}  // namespace
}  // namespace gmapping_spa::localization
