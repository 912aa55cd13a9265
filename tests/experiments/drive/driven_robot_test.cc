// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/drive/driven_robot.h"

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>

#include "experiments/simulation/carmen_writer.h"
#include "tests/experiments/drive/driven_room.h"

namespace gmapping_spa::drive {
namespace {

TEST(DrivenRobot, StandsWithoutACommand) {
  DrivenRoom room;
  room.Drive({}, 10);
  EXPECT_EQ(room.robot.world_T_robot(), (backend::SE2{2.0, 3.0, 0.0}));
  EXPECT_DOUBLE_EQ(room.robot.time_s(), 1.0);
  EXPECT_EQ(room.robot.Summary().world_T_robot.size(), 10u);
}

TEST(DrivenRobot, GetsUpToTheWantedVelocityAsFastAsItCan) {
  DrivenRoom room;
  room.Drive({1.0, 0.0}, 5);
  EXPECT_NEAR(room.robot.velocity().linear_m_s, 0.5, 1e-9);
  room.Drive({1.0, 0.0}, 10);
  EXPECT_DOUBLE_EQ(room.robot.velocity().linear_m_s, 1.0);
  EXPECT_NEAR(room.robot.world_T_robot().y, 3.0, 1e-9);
  room.Drive({0.0, 0.5}, 30);
  EXPECT_DOUBLE_EQ(room.robot.velocity().linear_m_s, 0.0);
  EXPECT_GT(room.robot.world_T_robot().theta, 1.0);
}

TEST(DrivenRobot, WallStopsItAndLetsItGoBack) {
  DrivenRoom room;
  room.Drive({1.5, 0.0}, 100);
  EXPECT_STREQ(room.robot.blocked_by(), "a wall");
  EXPECT_EQ(room.robot.velocity().linear_m_s, 0.0);
  const double x = room.robot.world_T_robot().x;
  EXPECT_GT(x, 7.4);
  EXPECT_LE(x, 7.9 - 0.3);
  room.Drive({0.0, 0.5}, 20);  // turns where it stands
  EXPECT_GT(room.robot.world_T_robot().theta, 0.5);
  room.Drive({-1.0, 0.0}, 20);
  EXPECT_EQ(room.robot.blocked_by(), nullptr);
  EXPECT_LT(room.robot.world_T_robot().x, x - 0.5);
}

TEST(DrivenRobot, PedestrianStopsIt) {
  simulation::Scene scene(simulation::Room());
  scene.pedestrian = {{0.2, 0.4}, 0.0, {{4.0, 3.0}, {4.0, 4.0}}};
  DrivenRobot robot(&scene, {2.0, 3.0, 0.0}, RoomOptions());
  RecordedTour tour(RoomOptions().lidar);
  for (int i = 0; i < 50; ++i) tour.Drive({{1.0, 0.0}}, &robot);
  EXPECT_STREQ(robot.blocked_by(), "the pedestrian");
  EXPECT_LT(robot.world_T_robot().x, 3.7);
}

std::string LogOf(double noise, double slips_per_m) {
  DrivenRoom room;
  room.noise = noise;
  room.slips_per_m = slips_per_m;
  room.Drive({1.0, 0.3}, 40);
  room.Drive({0.0, -0.5}, 20);
  std::ostringstream log;
  simulation::CarmenWriter writer(log);
  room.tour.Play(0, room.tour.steps(), &writer);
  return log.str();
}

TEST(DrivenRobot, SameCommandsGiveTheSameLog) {
  EXPECT_EQ(LogOf(1.0, 0.01), LogOf(1.0, 0.01));
  EXPECT_NE(LogOf(1.0, 0.01), LogOf(5.0, 0.01));
  EXPECT_NE(LogOf(1.0, 0.01), LogOf(1.0, 5.0));
}

// What drives does not matter: the readings are those of a tour by way points.
TEST(DrivenRobot, ReadingsAreThoseOfASimulatedTour) {
  class Counter : public simulation::LogSink {
   public:
    void OnOdometry(const simulation::OdometryReading&) override { ++odometry; }
    void OnScan(const simulation::OdometryReading& reading, const simulation::LidarOptions&,
                const std::vector<double>& ranges_m) override {
      if (!first) first = {reading.stamp_s, ranges_m};
      ++scans;
    }
    int odometry = 0, scans = 0;
    std::optional<std::pair<double, std::vector<double>>> first;
  };
  Counter tour, driven;
  simulation::Simulate(RoomScene(), {{2.0, 3.0}, {6.0, 3.0}}, RoomOptions(), &tour);
  DrivenRoom room;
  room.Drive({1.0, 0.0}, 20);
  room.tour.Play(0, room.tour.steps(), &driven);
  EXPECT_EQ(driven.first, tour.first);
  EXPECT_EQ(driven.odometry, 40);
  EXPECT_EQ(driven.scans, 20);
}

}  // namespace
}  // namespace gmapping_spa::drive
