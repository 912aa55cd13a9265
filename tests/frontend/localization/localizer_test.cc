// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/localization/localizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "tests/frontend/localization/known_hall.h"

namespace gmapping_spa::localization {
namespace {

using backend::SE2;

struct Outcome {
  std::optional<Located> located;
  std::size_t scan = 0;  // by which it was found
};

Outcome Localize(const map::OccupancyGrid& map, const std::vector<sensor::LaserScan>& scans) {
  Localizer localizer({}, &map);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const SE2 motion = k > 0 ? Between(scans[k - 1].odom_T_robot, scans[k].odom_T_robot) : SE2{};
    if (const auto located = localizer.AddScan(scans[k], motion).located) return {located, k};
  }
  return {};
}

// Two rooms at either end of a passage, alike to the last corner: turned by half a turn about the
// middle of the passage all is the same.
synthetic::Walls TwinRooms() {
  synthetic::Walls walls;
  synthetic::AddPolygon({{-14, -3},
                         {-6, -3},
                         {-6, -1},
                         {6, -1},
                         {6, -3},
                         {13, -3},
                         {14, -1.5},
                         {14, 3},
                         {6, 3},
                         {6, 1},
                         {-6, 1},
                         {-6, 3},
                         {-13, 3},
                         {-14, 1.5}},
                        0.0, &walls);
  return walls;
}

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

TEST(Localizer, NeverFindsARobotInAnotherBuilding) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  EXPECT_FALSE(Localize(map, synthetic::Driven(synthetic::Ring(), 0.0, 47.0)).located);
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

TEST(Localizer, OfTwinRoomsItBelievesNeither) {
  map::OccupancyGrid map({});
  const synthetic::Laser laser{.beams = 360, .field_of_view_rad = 6.2, .usable_range_m = 6.0};
  const auto scan_at = [&](const SE2& pose) { return synthetic::Scan(TwinRooms(), pose, laser); };
  for (double x = -12.0; x <= 12.0; x += 0.25) {
    map::InsertScan(scan_at({x, 0, 0}), {x, 0, 0}, {}, &map);
  }
  Localizer localizer({}, &map);
  for (double x = -11.0; x < 11.0; x += 0.1) {
    EXPECT_FALSE(localizer.AddScan(scan_at({x, 0, 0}), x > -11.0 ? SE2{0.1, 0, 0} : SE2{}).located)
        << x;
  }
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
