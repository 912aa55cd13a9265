// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/way_planner.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/drive/driven_robot.h"
#include "experiments/drive/recorded_tour.h"
#include "experiments/simulation/scene.h"

namespace gmapping_spa::drive {
namespace {

const simulation::World& Building() {
  static const auto& world =
      *new simulation::World(simulation::ReadWorldRaster(WORLDS_FOLDER "/paper_building.yaml"));
  return world;
}

double LengthM(const simulation::WayPoints& way) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length_m += (way[i] - way[i - 1]).norm();
  return length_m;
}

TEST(WayPlanner, StraightWhereNothingIsInTheWay) {
  const simulation::WayPoints way = PlanWay(Building(), {10.0, 8.2}, {14.0, 8.2}, 0.5);
  ASSERT_EQ(way.size(), 2u);
  EXPECT_EQ(way.front(), Eigen::Vector2d(10.0, 8.2));
  EXPECT_EQ(way.back(), Eigen::Vector2d(14.0, 8.2));
}

TEST(WayPlanner, RobotGetsThroughADoorIntoAnOffice) {
  const simulation::WayPoints way = PlanWay(Building(), {10.0, 8.2}, {20.1, 4.2}, 0.5);
  ASSERT_GT(way.size(), 2u);
  EXPECT_LT(LengthM(way), 14.0);
  const simulation::Scene scene(Building());
  simulation::SimulationOptions options;
  options.lidar.beams = 4;
  DrivenRobot robot(&scene, {10.0, 8.2, 0.0}, options);
  RecordedTour tour(options.lidar);
  simulation::WayPointFollower follower(way, options.follower);
  while (!follower.Done() && robot.time_s() < 60.0) {
    tour.Drive({follower.Next(robot.world_T_robot(), robot.scan_period_s())}, &robot);
    ASSERT_EQ(robot.blocked_by(), nullptr);
  }
  EXPECT_LT((robot.world_T_robot().translation() - way.back()).norm(), 0.5);
}

TEST(WayPlanner, NoneIntoAWallOrOutOfTheWorld) {
  EXPECT_TRUE(PlanWay(Building(), {10.0, 8.2}, {8.3, 3.0}, 0.5).empty());
  EXPECT_TRUE(PlanWay(Building(), {10.0, 8.2}, {-5.0, 8.2}, 0.5).empty());
}

}  // namespace
}  // namespace gmapping_spa::drive
