// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/simulation/carmen_writer.h"

namespace gmapping_spa::simulation {
namespace {

using map::CellState;
using testing::HasSubstr;

// An empty world of 20 m x 10 m with a wall at x from 12 to 12.5 m and y from 4 m up.
World Yard() {
  map::TrinaryMap raster{200, 100, 0.1, 0.0, 0.0, std::vector<CellState>(20000, CellState::kFree)};
  for (int row = 40; row < 100; ++row) {
    for (int column = 120; column < 125; ++column) raster.at(column, row) = CellState::kOccupied;
  }
  return World(raster);
}

SimulationOptions OneDegreeBeams() {
  SimulationOptions options;
  options.lidar.beams = 360;
  return options;
}

// For tests in which only the tour matters.
class Nowhere : public LogSink {
  void OnOdometry(const OdometryReading& /*reading*/) override {}
  void OnScan(const OdometryReading& /*odometry*/, const LidarOptions& /*lidar*/,
              const std::vector<double>& /*ranges_m*/) override {}
};

SimulationSummary Drive(const Scene& scene, const WayPoints& way_points,
                        const SimulationOptions& options) {
  Nowhere nowhere;
  return Simulate(scene, way_points, options, &nowhere);
}

int CountLines(const std::string& text, const std::string& start) {
  std::istringstream in(text);
  int count = 0;
  for (std::string line; std::getline(in, line);) count += line.starts_with(start);
  return count;
}

TEST(Simulation, WritesTwoOdometryReadingsAScan) {
  std::ostringstream log;
  CarmenWriter writer(log);
  SimulationOptions options = OneDegreeBeams();
  options.follower.max_speed_m_s = 1.0;
  const SimulationSummary summary = Simulate(Yard(), {{2, 2}, {12, 2}}, options, &writer);
  const int scans = static_cast<int>(summary.world_T_robot.size());
  EXPECT_GT(scans, 90);
  EXPECT_EQ(CountLines(log.str(), "ROBOTLASER1 "), scans);
  EXPECT_NEAR(CountLines(log.str(), "ODOM "), 2 * scans, 1);
  EXPECT_NEAR(summary.path_length_m, 10.0, 0.3);
  for (int i = 0; i < scans; ++i) EXPECT_DOUBLE_EQ(summary.world_T_robot[i].stamp_s, i / 10.0);
  EXPECT_EQ(summary.world_T_robot.front().world_T_robot, (backend::SE2{2.0, 2.0, 0.0}));
}

TEST(Simulation, SameSeedGivesTheSameBytesAndAnotherSeedAnotherLog) {
  const WayPoints way_points = {{2, 2}, {8, 2}, {8, 6}};
  const auto log_of = [&](std::uint64_t seed) {
    std::ostringstream log;
    CarmenWriter writer(log);
    SimulationOptions options = OneDegreeBeams();
    options.seed = seed;
    Simulate(Yard(), way_points, options, &writer);
    return log.str();
  };
  const std::string log = log_of(4);
  EXPECT_EQ(log, log_of(4));
  EXPECT_NE(log, log_of(5));
}

TEST(Simulation, TruthIsWhatTheLaserSees) {
  SimulationOptions options;
  options.lidar.beams = 4;
  options.lidar.range_noise_m = 0.0;
  // Straight towards the wall.
  struct CheckScans : Nowhere {
    std::vector<std::vector<double>> scans;
    void OnScan(const OdometryReading& /*odometry*/, const LidarOptions& /*lidar*/,
                const std::vector<double>& ranges_m) override {
      scans.push_back(ranges_m);
    }
  } seen;
  const SimulationSummary summary = Simulate(Yard(), {{2, 6}, {9, 6}}, options, &seen);
  ASSERT_EQ(seen.scans.size(), summary.world_T_robot.size());
  for (std::size_t i = 0; i < seen.scans.size(); ++i) {
    EXPECT_NEAR(seen.scans[i][2], 12.0 - summary.world_T_robot[i].world_T_robot.x, 0.00051) << i;
  }
}

TEST(Simulation, NamesThePlaceWhereTheRobotWouldTouchAWall) {
  try {
    Drive(Yard(), {{2, 6}, {18, 6}}, OneDegreeBeams());
    FAIL() << "drove through a wall";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("found a wall at (12.00, 6.00)"));
  }
}

TEST(Simulation, NamesThePlaceWhereTheRobotWouldTouchThePedestrian) {
  // Comes towards the robot.
  const Scene scene(Yard(), Pedestrian{{0.2, 0.4}, 1.0, {{10, 2}, {2, 2}}});
  try {
    Drive(scene, {{2, 2}, {10, 2}}, OneDegreeBeams());
    FAIL() << "ran into the pedestrian";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("found the pedestrian at ("));
  }
}

TEST(Simulation, GivesUpOnATourThatItCannotDrive) {
  SimulationOptions options = OneDegreeBeams();
  options.follower.max_acceleration_m_s2 = 0.0;
  EXPECT_THROW(Drive(Yard(), {{2, 2}, {4, 2}}, options), std::runtime_error);
}

// Keeps the readings.
struct Readings : LogSink {
  std::vector<OdometryReading> odometry;
  std::vector<double> scan_stamps_s;
  std::vector<std::vector<double>> scans;
  void OnOdometry(const OdometryReading& reading) override { odometry.push_back(reading); }
  void OnScan(const OdometryReading& reading, const LidarOptions& /*lidar*/,
              const std::vector<double>& ranges_m) override {
    scan_stamps_s.push_back(reading.stamp_s);
    scans.push_back(ranges_m);
  }
};

TEST(Simulation, ACoveredLaserReadsTheSameEverywhere) {
  SimulationOptions options = OneDegreeBeams();
  options.covered = {{1.0, 2.0}};
  options.covered_range_m = 0.02;
  Readings readings;
  Simulate(Yard(), {{2, 2}, {9, 2}}, options, &readings);
  for (std::size_t i = 0; i < readings.scans.size(); ++i) {
    const double stamp_s = readings.scan_stamps_s[i];
    const bool covered = stamp_s >= 1.0 && stamp_s < 2.0;
    EXPECT_EQ(readings.scans[i] == std::vector<double>(360, 0.02), covered) << stamp_s;
  }
  options.covered_range_m = 100.0;  // no return: no more than the laser's range
  Readings without_return;
  Simulate(Yard(), {{2, 2}, {9, 2}}, options, &without_return);
  EXPECT_EQ(without_return.scans[15], std::vector<double>(360, 30.0));
}

TEST(Simulation, GapsHaveOdometryButNoScans) {
  SimulationOptions options = OneDegreeBeams();
  options.without_scan = {{1.0, 2.0}};
  Readings readings;
  const SimulationSummary summary = Simulate(Yard(), {{2, 2}, {9, 2}}, options, &readings);
  EXPECT_EQ(readings.scan_stamps_s[9], 0.9);
  EXPECT_EQ(readings.scan_stamps_s[10], 2.0);
  EXPECT_EQ(summary.world_T_robot[10].stamp_s, 2.0);
  EXPECT_EQ(readings.odometry[30].stamp_s, 1.5);
  options.without_scan = {{0.0, 1e6}};
  EXPECT_THROW(Drive(Yard(), {{2, 2}, {9, 2}}, options), std::runtime_error);
}

TEST(Simulation, ARobotThatIsCarriedGoesOnElsewhereAndItsWheelsKnowNothing) {
  SimulationOptions options = OneDegreeBeams();
  options.odometry.noise = options.odometry.interference = 0.0;
  options.carry_s = 2.0;
  const WayPoints first = {{2, 2}, {6, 2}};
  options.carried_to = {{{15, 8}, {15, 2}}};
  Readings readings;
  const SimulationSummary summary = Simulate(Yard(), first, options, &readings);
  const std::size_t before =
      std::find_if(summary.world_T_robot.begin(), summary.world_T_robot.end(),
                   [](const auto& pose) { return pose.world_T_robot.x > 10.0; }) -
      summary.world_T_robot.begin() - 1;
  const auto& from = summary.world_T_robot[before];
  const auto& to = summary.world_T_robot[before + 1];
  EXPECT_NEAR(to.stamp_s - from.stamp_s, 2.1, 0.11);
  EXPECT_NEAR(to.world_T_robot.x, 15.0, 1e-9);
  // In the odometry the second tour begins where the first one ends.
  const backend::SE2 expected =
      Inverse(backend::SE2{2, 2, 0}) * from.world_T_robot *
      backend::Between(to.world_T_robot, summary.world_T_robot.back().world_T_robot);
  EXPECT_NEAR((summary.odom_T_robot.translation() - expected.translation()).norm(), 0.0, 0.05);
}

TEST(Simulation, WithoutErrorsTheOdometryIsTheTruth) {
  SimulationOptions options = OneDegreeBeams();
  options.odometry.noise = options.odometry.interference = 0.0;
  options.follower.reverse = true;
  options.follower.turns_at_way_points = 1.0;
  struct Odometries : Nowhere {
    std::vector<backend::SE2> odom_T_robot;
    void OnScan(const OdometryReading& reading, const LidarOptions& /*lidar*/,
                const std::vector<double>& /*ranges_m*/) override {
      odom_T_robot.push_back(reading.odom_T_robot);
    }
  } odometries;
  const SimulationSummary summary =
      Simulate(Yard(), {{2, 2}, {9, 2}, {9, 8}, {2, 8}}, options, &odometries);
  ASSERT_EQ(odometries.odom_T_robot.size(), summary.world_T_robot.size());
  const backend::SE2 world_T_odom = summary.world_T_robot.front().world_T_robot;
  for (std::size_t i = 0; i < odometries.odom_T_robot.size(); ++i) {
    const backend::SE2 error = backend::Between(summary.world_T_robot[i].world_T_robot,
                                                world_T_odom * odometries.odom_T_robot[i]);
    EXPECT_LT(error.translation().norm(), 1e-5);
    EXPECT_LT(std::abs(error.theta), 1e-5);
  }
}

TEST(Simulation, TheCrowdIsSeenAndNeverTouchesTheRobot) {
  SimulationOptions options = OneDegreeBeams();
  options.lidar.range_noise_m = 0.0;
  Readings alone, crowd;
  Simulate(Yard(), {{2, 2}, {9, 2}}, options, &alone);
  options.walkers = 20;
  Simulate(Yard(), {{2, 2}, {9, 2}}, options, &crowd);
  ASSERT_EQ(crowd.scans.size(), alone.scans.size());
  int nearer = 0;
  for (std::size_t i = 0; i < alone.scans.size(); ++i) {
    for (std::size_t beam = 0; beam < 360; ++beam) {
      EXPECT_LE(crowd.scans[i][beam], alone.scans[i][beam]);
      nearer += crowd.scans[i][beam] < alone.scans[i][beam];
    }
  }
  EXPECT_GT(nearer / static_cast<double>(alone.scans.size()), 10.0);  // beams a scan
}

}  // namespace
}  // namespace gmapping_spa::simulation
