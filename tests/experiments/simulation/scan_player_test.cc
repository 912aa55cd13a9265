// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/scan_player.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <sstream>
#include <vector>

#include "experiments/simulation/carmen_writer.h"
#include "experiments/simulation/simulation.h"
#include "frontend/sensor/open_log.h"
#include "tests/experiments/simulation/room.h"

namespace gmapping_spa::simulation {
namespace {

// Several turns of the robot, so that its heading passes half a turn, and beams without return.
SimulationOptions Options() {
  SimulationOptions options;
  options.lidar.beams = 77;
  options.lidar.max_range_m = 4.0;
  options.lidar.motion_during_scan = true;
  options.lidar.fov_rad = 4.0;
  options.lidar.fov_center_rad = 0.3;
  options.lidar.robot_T_laser = {-0.2, 0.1, 3.0};
  options.without_scan = {{2.0, 3.0}};
  options.odometry.noise = 5.0;
  return options;
}
const WayPoints kTour = {{2, 2}, {6, 2}, {6, 4}, {2, 4}, {2, 2}, {6, 2}, {6, 4}, {2, 4}};

TEST(ScanPlayer, PlaysWhatAReaderOfTheLogReads) {
  std::vector<sensor::LaserScan> played;
  ScanPlayer player([&](const sensor::LaserScan& scan) { played.push_back(scan); });
  Simulate(Room(), kTour, Options(), &player);

  auto log = std::make_unique<std::stringstream>();
  CarmenWriter writer(*log);
  Simulate(Room(), kTour, Options(), &writer);
  const auto reader = sensor::OpenCarmenLog(std::move(log), "simulated", {});

  ASSERT_GT(played.size(), 100u);
  int no_return = 0;
  for (const sensor::LaserScan& scan : played) {
    const std::optional<sensor::LaserScan> read = reader->Next();
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(scan.index, read->index);
    EXPECT_EQ(scan.stamp_s, read->stamp_s);
    EXPECT_EQ(scan.odom_T_robot, read->odom_T_robot);
    EXPECT_NEAR(scan.robot_T_laser.x, read->robot_T_laser.x, 1e-6);
    EXPECT_NEAR(scan.robot_T_laser.y, read->robot_T_laser.y, 1e-6);
    EXPECT_NEAR(scan.robot_T_laser.theta, read->robot_T_laser.theta, 1e-6);
    ASSERT_EQ(scan.beams.size(), read->beams.size());
    for (std::size_t i = 0; i < scan.beams.size(); ++i) {
      EXPECT_EQ(scan.beams[i].angle_rad, read->beams[i].angle_rad);
      EXPECT_EQ(scan.beams[i].range_m, read->beams[i].range_m);
      EXPECT_EQ(scan.beams[i].status, read->beams[i].status);
      no_return += scan.beams[i].status == sensor::BeamStatus::kNoReturn;
    }
  }
  EXPECT_FALSE(reader->Next().has_value());
  EXPECT_GT(no_return, 100);
}

}  // namespace
}  // namespace gmapping_spa::simulation
