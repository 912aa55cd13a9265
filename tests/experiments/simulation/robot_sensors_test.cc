// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/robot_sensors.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/experiments/simulation/room.h"

namespace gmapping_spa::simulation {
namespace {

class Stamps : public LogSink {
 public:
  void OnOdometry(const OdometryReading& reading) override {
    odometry_s.push_back(reading.stamp_s);
  }
  void OnScan(const OdometryReading& reading, const LidarOptions&,
              const std::vector<double>&) override {
    scans_s.push_back(reading.stamp_s);
  }
  std::vector<double> odometry_s, scans_s;
};

class RobotSensorsTest : public testing::Test {
 protected:
  RobotSensorsTest() { options_.lidar.beams = 8; }

  // Forwards for so many steps of 0.05 s.
  void Read(int steps, RobotSensors* sensors) {
    for (int i = 0; i < steps; ++i) {
      const backend::SE2 world_T_robot = {2.0 + 0.05 * step_, 3.0, 0.0};
      sensors->Read(scene_, {0.05 * step_++, world_T_robot, {1.0, 0.0}, {1.0, 0.0}}, &stamps_);
    }
  }

  const Scene scene_ = Room();
  SimulationOptions options_;
  Stamps stamps_;
  int step_ = 0;
};

TEST_F(RobotSensorsTest, ScanComesWithEverySecondReadingOfTheWheels) {
  RobotSensors sensors(options_);
  Read(5, &sensors);
  EXPECT_EQ(stamps_.odometry_s, (std::vector<double>{0.0, 0.05, 0.1, 0.15, 0.2}));
  EXPECT_EQ(stamps_.scans_s, (std::vector<double>{0.0, 0.1, 0.2}));
  EXPECT_EQ(sensors.Summary().world_T_robot.size(), 3u);
  EXPECT_NEAR(sensors.Summary().path_length_m, 0.25, 1e-12);
}

TEST_F(RobotSensorsTest, NoiseAndSlipsChangeFromAStepOn) {
  options_.odometry = {.noise = 0.0, .interference = 0.0};
  RobotSensors sensors(options_);
  Read(20, &sensors);
  EXPECT_NEAR(sensors.odom_T_robot().x, 1.0, 1e-12);
  EXPECT_EQ(sensors.odom_T_robot().y, 0.0);
  sensors.SetOdometryNoise(5.0);
  sensors.SetSlips(1000.0);
  Read(20, &sensors);
  EXPECT_NE(sensors.odom_T_robot().y, 0.0);
  EXPECT_GT(sensors.Summary().slips, 10);
}

}  // namespace
}  // namespace gmapping_spa::simulation
