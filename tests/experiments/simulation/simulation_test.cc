#include "experiments/simulation/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace gmapping_spa::simulation
