// SPDX-License-Identifier: BSD-3-Clause
// The paper's building: its tours and its obstacles.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/simulation/scan_player.h"
#include "experiments/simulation/simulation.h"
#include "experiments/simulation/truth_map.h"

namespace gmapping_spa::simulation::paper_building_test {
namespace {

using map::CellState;

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

std::string InWorlds(const std::string& file) { return std::string(WORLDS_FOLDER "/") + file; }

SimulationSummary Drive(const Scene& scene, const char* path, const SimulationOptions& options) {
  ScanPlayer nowhere([](const sensor::LaserScan& /*scan*/) {});
  return Simulate(scene, ReadTours(InWorlds(path)).front(), options, &nowhere);
}

SimulationOptions OneBeam() {
  SimulationOptions options;
  options.lidar.beams = 1;
  return options;
}

TEST(PaperBuilding, TourTouchesNoWallAndClosesLoops) {
  const Scene scene = Scene::Read(InWorlds("paper_building.yaml"), "", false);
  EXPECT_EQ(scene.world.raster().width, 1880);
  EXPECT_EQ(scene.world.raster().height, 1320);
  const SimulationSummary summary = Drive(scene, "paper_building.path.yaml", OneBeam());
  EXPECT_GT(summary.path_length_m, 180.0);
  EXPECT_LT(summary.path_length_m, 250.0);
  EXPECT_GE(CountReturns(summary.world_T_robot), 3);
}

TEST(PaperBuilding, ShortTourClosesALoop) {
  const Scene scene = Scene::Read(InWorlds("paper_building.yaml"), "", false);
  const SimulationSummary summary = Drive(scene, "paper_building.short.path.yaml", OneBeam());
  EXPECT_GT(summary.path_length_m, 60.0);
  EXPECT_LT(summary.path_length_m, 80.0);
  EXPECT_GE(CountReturns(summary.world_T_robot), 1);
}

// The sides of the box that the laser sees on the way: 'W', 'E', 'S', 'N'.
std::set<char> SidesSeen(const World& world, const backend::Trajectory& trajectory,
                         const Eigen::Vector2d& min, const Eigen::Vector2d& max) {
  constexpr double kMarginM = 1e-6;
  constexpr int kEnough = 10;  // beams
  std::map<char, int> beams;
  for (std::size_t i = 0; i < trajectory.size(); i += 5) {
    const Eigen::Vector2d from = trajectory[i].world_T_robot.translation();
    for (double angle_rad = 0.0; angle_rad < 6.28; angle_rad += 0.02) {
      const std::optional<double> range_m = world.CastRay(from, angle_rad, 30.0);
      if (!range_m) continue;
      const Eigen::Vector2d hit =
          from + *range_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
      if ((hit.array() < min.array() - kMarginM).any()) continue;
      if ((hit.array() > max.array() + kMarginM).any()) continue;
      beams['W'] += hit.x() < min.x() + kMarginM;
      beams['E'] += hit.x() > max.x() - kMarginM;
      beams['S'] += hit.y() < min.y() + kMarginM;
      beams['N'] += hit.y() > max.y() - kMarginM;
    }
  }
  std::set<char> sides;
  for (const auto& [side, count] : beams) {
    if (count >= kEnough) sides.insert(side);
  }
  return sides;
}

TEST(PaperBuilding, ObstaclesAreSeenFromSeveralSides) {
  const Scene scene =
      Scene::Read(InWorlds("paper_building.yaml"), InWorlds("paper_obstacles.yaml"), false);
  const backend::Trajectory trajectory =
      Drive(scene, "paper_building.path.yaml", OneBeam()).world_T_robot;
  const auto sides = [&](const Eigen::Vector2d& min, const Eigen::Vector2d& max) {
    return SidesSeen(scene.world, trajectory, min, max);
  };
  EXPECT_EQ(sides({11.5, 14.8}, {12, 17.8}), (std::set<char>{'E', 'N', 'W'}));
  EXPECT_EQ(sides({15.5, 14}, {18.5, 14.5}), (std::set<char>{'E', 'N', 'S', 'W'}));
  EXPECT_EQ(sides({40.5, 7.4}, {40.7, 7.8}), (std::set<char>{'N', 'W'}));
}

TEST(PaperBuilding, TrueMapHasThePedestrianWhenItStands) {
  for (const bool walks : {false, true}) {
    const Scene scene =
        Scene::Read(InWorlds("paper_building.yaml"), InWorlds("paper_obstacles.yaml"), walks);
    const map::TrinaryMap truth = TruthMap(scene.world, {3, 8.2}, 0.05);
    EXPECT_EQ(truth.at(230, 320), CellState::kOccupied);  // the western side of the left obstacle
    EXPECT_EQ(truth.at(810, 150), walks ? CellState::kFree : CellState::kOccupied);
  }
}

// The paper's robot drives at 1.5 to 3 m/s and turns at 0.6 to 1 rad/s.
struct Limits {
  double speed_m_s, turn_rate_rad_s;
};
class PaperObstacles : public testing::TestWithParam<Limits> {};

TEST_P(PaperObstacles, AreNotTouchedOnAnyTour) {
  SimulationOptions options = OneBeam();
  options.follower.max_speed_m_s = GetParam().speed_m_s;
  options.follower.max_turn_rate_rad_s = GetParam().turn_rate_rad_s;
  for (const bool walks : {false, true}) {
    const Scene scene =
        Scene::Read(InWorlds("paper_building.yaml"), InWorlds("paper_obstacles.yaml"), walks);
    EXPECT_EQ(scene.pedestrian.has_value(), walks);
    for (const char* path : {"paper_building.path.yaml", "paper_building.short.path.yaml"}) {
      EXPECT_NO_THROW(Drive(scene, path, options)) << path;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Limits, PaperObstacles,
                         testing::Values(Limits{1.5, 0.6}, Limits{1.5, 1.0}, Limits{3.0, 0.6},
                                         Limits{3.0, 1.0}),
                         [](const auto& test) {
                           return "Speed" + std::to_string(int(10 * test.param.speed_m_s)) +
                                  "TurnRate" + std::to_string(int(10 * test.param.turn_rate_rad_s));
                         });

}  // namespace
}  // namespace gmapping_spa::simulation::paper_building_test
