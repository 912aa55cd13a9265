#include "experiments/simulation/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

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

int CountLines(const std::string& text, const std::string& start) {
  std::istringstream in(text);
  int count = 0;
  for (std::string line; std::getline(in, line);) count += line.starts_with(start);
  return count;
}

TEST(Simulation, WritesTwoOdometryReadingsAScan) {
  std::ostringstream log;
  SimulationOptions options;
  options.follower.max_speed_m_s = 1.0;
  const SimulationSummary summary = Simulate(Yard(), {{2, 2}, {12, 2}}, options, log);
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
    SimulationOptions options;
    options.seed = seed;
    Simulate(Yard(), way_points, options, log);
    return log.str();
  };
  const std::string log = log_of(4);
  EXPECT_EQ(log, log_of(4));
  EXPECT_NE(log, log_of(5));
}

TEST(Simulation, NamesThePlaceWhereTheRobotWouldTouchAWall) {
  std::ostringstream log;
  try {
    Simulate(Yard(), {{2, 6}, {18, 6}}, {}, log);
    FAIL() << "drove through a wall";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("found a wall at (12.00, 6.00)"));
  }
}

TEST(Simulation, GivesUpOnATourThatItCannotDrive) {
  std::ostringstream log;
  SimulationOptions options;
  options.follower.max_acceleration_m_s2 = 0.0;
  EXPECT_THROW(Simulate(Yard(), {{2, 2}, {4, 2}}, options, log), std::runtime_error);
}

// How often the tour comes back to within 1 m of a place that it left at least 30 m before.
int CountReturns(const backend::Trajectory& trajectory) {
  std::vector<double> travelled_m = {0.0};
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    travelled_m.push_back(travelled_m.back() + (trajectory[i].world_T_robot.translation() -
                                                trajectory[i - 1].world_T_robot.translation())
                                                   .norm());
  }
  int returns = 0;
  bool was_back = false;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    bool back = false;
    for (std::size_t j = 0; j < i && travelled_m[i] - travelled_m[j] > 30.0 && !back; ++j) {
      back = (trajectory[i].world_T_robot.translation() - trajectory[j].world_T_robot.translation())
                 .norm() < 1.0;
    }
    returns += back && !was_back;
    was_back = back;
  }
  return returns;
}

TEST(PaperBuilding, TourTouchesNoWallAndClosesLoops) {
  const std::string folder = WORLDS_FOLDER;
  const World world = World::Read(folder + "/paper_building.yaml");
  EXPECT_EQ(world.raster().width, 1880);
  EXPECT_EQ(world.raster().height, 1320);
  std::ostringstream log;
  SimulationOptions options;
  options.lidar.beams = 1;  // Only the tour matters.
  const SimulationSummary summary =
      Simulate(world, ReadWayPoints(folder + "/paper_building.path.yaml"), options, log);
  EXPECT_GT(summary.path_length_m, 180.0);
  EXPECT_LT(summary.path_length_m, 250.0);
  EXPECT_GE(CountReturns(summary.world_T_robot), 3);
}

}  // namespace
}  // namespace gmapping_spa::simulation
