// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/localization/place_guesses.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/frontend/localization/known_hall.h"

namespace gmapping_spa::localization {
namespace {

using backend::SE2;

Views ViewsOf(const std::vector<sensor::LaserScan>& scans) {
  Views views({});
  for (std::size_t k = 0; k < scans.size(); ++k) {
    views.Add(scans[k], k > 0 ? Between(scans[k - 1].odom_T_robot, scans[k].odom_T_robot) : SE2{});
  }
  return views;
}

TEST(PlaceGuesses, TheBestOneIsWhereTheRobotIsWhateverItsHeading) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  const PlaceGuesses guesses({}, &map);
  for (const double from_m : {2.0, 14.0, 27.0, 40.0}) {
    const auto scans = synthetic::Driven(synthetic::Hall(), from_m, from_m + 1.5);
    const std::vector<PlaceGuess> found = guesses.Find(ViewsOf(scans));
    ASSERT_FALSE(found.empty()) << from_m;
    const SE2 off = Between(scans.back().odom_T_robot, found.front().map_T_robot);
    EXPECT_LT(off.translation().norm(), 0.03) << from_m;
    EXPECT_LT(std::abs(off.theta), 0.01) << from_m;
    EXPECT_GT(found.front().Support(), 0.7) << from_m;
    for (std::size_t k = 1; k < found.size(); ++k) {
      EXPECT_LE(found[k].Support(), found[k - 1].Support());
    }
  }
}

// Two rooms with a thin wall between them, and where else the same stands.
void AddRooms(const SE2& world_T_rooms, synthetic::Walls* walls) {
  const auto add = [&](std::vector<Eigen::Vector2d> corners) {
    for (Eigen::Vector2d& corner : corners) corner = world_T_rooms * corner;
    synthetic::AddPolygon(corners, 0.0, walls);
  };
  add({{-5, -3}, {5, -3}, {5, 2}, {3.5, 2}, {3.5, 3}, {-5, 3}});
  add({{-1, -2.5}, {-0.85, -2.5}, {-0.85, 0.8}, {-1, 0.8}});
}

// Wherever the cells of the search lie: an alignment may end at the wrong side of the wall.
TEST(PlaceGuesses, ATwinIsAsGoodAsThePlaceItself) {
  const SE2 twin{30.07, 0.11, 3.1415};
  synthetic::Walls walls;
  AddRooms({}, &walls);
  AddRooms(twin, &walls);
  const synthetic::Laser laser{.beams = 360, .field_of_view_rad = 6.2, .usable_range_m = 9.0};
  map::OccupancyGrid map({});
  for (double x = -4.0; x <= 4.0; x += 0.25) {
    for (const double y : {-2.0, 1.5}) {
      if (y < 0 && std::abs(x + 1) < 0.5) continue;
      for (const SE2& pose : {SE2{x, y, 0}, twin * SE2{x, y, 0}}) {
        map::InsertScan(synthetic::Scan(walls, pose, laser), pose, {}, &map);
      }
    }
  }
  const PlaceGuesses guesses({}, &map);
  for (double off_m = 0.0; off_m < 0.4; off_m += 0.03) {
    std::vector<sensor::LaserScan> scans;
    for (double x = -3.0; x < 2.0; x += 0.4) {
      const SE2 pose{x + off_m, 1.2 + 0.7 * off_m, 0};
      scans.push_back(synthetic::Scan(walls, pose, laser));
      scans.back().odom_T_robot = pose;
    }
    double here = -1.0, there = -1.0;
    for (const PlaceGuess& guess : guesses.Find(ViewsOf(scans))) {
      double& best = guess.map_T_robot.x < 15.0 ? here : there;
      best = std::max(best, guess.Support());
    }
    EXPECT_GT(here, 0.7) << off_m;
    EXPECT_NEAR(here, there, 0.1) << off_m;
  }
}

// Each beam that ends behind a wall of the map has passed through it.
TEST(PlaceGuesses, WhatIsSeenThroughAWallIsNoUnknownLand) {
  synthetic::Walls small, large;
  synthetic::AddPolygon({{-3, -2}, {3, -2}, {3, 2}, {-3, 2}}, 0.0, &small);
  synthetic::AddPolygon({{-6, -2}, {6, -2}, {6, 2}, {-6, 2}}, 0.0, &large);
  map::OccupancyGrid map({});
  const synthetic::Laser all_round{.beams = 360, .field_of_view_rad = 6.2};
  for (double x = -2.0; x <= 2.0; x += 0.1) {
    map::InsertScan(synthetic::Scan(small, {x, 0.5 * x, 0}, all_round), {x, 0.5 * x, 0}, {}, &map);
  }
  Views views({});
  views.Add(synthetic::Scan(large, {}, all_round), {});
  const std::vector<PlaceGuess> guesses = PlaceGuesses({}, &map).Find(views);
  ASSERT_FALSE(guesses.empty());
  for (const PlaceGuess& guess : guesses) {
    if (guess.map_T_robot.translation().norm() > 1.0) continue;
    EXPECT_GT(guess.evidence.contradicted, 0.05 * guess.evidence.all());
    EXPECT_LT(guess.evidence.unknown, 0.02 * guess.evidence.all());
  }
}

TEST(PlaceGuesses, InformationIsThatOfAllDirectionsWhereWallsStandInAll) {
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  const Views views = ViewsOf(synthetic::Driven(synthetic::Hall(), 5.0, 6.5));
  const SE2 map_T_robot = synthetic::OnRing(6.5);
  const Eigen::Matrix3d information = PlaceGuesses({}, &map).InformationAt(views, map_T_robot);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information);
  EXPECT_GT(solver.eigenvalues()[0], 1e3);
}

TEST(PlaceGuesses, ThereAreNoneInAnEmptyMapNorForARobotThatSeesNothing) {
  const map::OccupancyGrid nothing({});
  EXPECT_TRUE(
      PlaceGuesses({}, &nothing).Find(ViewsOf(synthetic::Driven(synthetic::Hall(), 0, 1))).empty());
  const map::OccupancyGrid map = synthetic::MapOf(synthetic::Hall());
  Views blind({});
  blind.Add(sensor::LaserScan{}, {});
  EXPECT_TRUE(PlaceGuesses({}, &map).Find(blind).empty());
}

}  // namespace
}  // namespace gmapping_spa::localization
