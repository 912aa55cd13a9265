// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/crowd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace gmapping_spa::simulation::crowd_test {
namespace {

using map::CellState;

constexpr double kStepsPerS = 20.0, kStepS = 1.0 / kStepsPerS, kRadiusM = 0.5;

// A corridor 30 m long and 3 m wide, in which walkers and robot must pass each other.
World Corridor() {
  map::TrinaryMap raster{300, 34, 0.1, 0.0, 0.0, std::vector<CellState>(10200, CellState::kFree)};
  for (int column = 0; column < 300; ++column) {
    for (const int row : {0, 1, 32, 33}) raster.at(column, row) = CellState::kOccupied;
  }
  return World(raster);
}

std::vector<MotionStep> ThereAndBack() {
  return DriveTours({{{2, 1.7}, {28, 1.7}, {2, 1.7}}}, {}, kStepsPerS, 0.0);
}

TEST(Crowd, TouchesNeitherWallsNorTheRobot) {
  const World world = Corridor();
  const std::vector<MotionStep> robot = ThereAndBack();
  int seen = 0;
  for (const Walk& walk : WalkAbout(world, robot, kRadiusM, 12, 3)) {
    for (const MotionStep& step : robot) {
      const std::optional<Rectangle> walker = walk.At(step.time_s);
      if (!walker) continue;
      ++seen;
      EXPECT_FALSE(world.FindContact(walker->center(), walker->half_size_m.norm()));
      const Eigen::Vector2d point = step.world_T_robot.translation();
      EXPECT_GT((walker->Nearest(point) - point).norm(), kRadiusM + 0.2);
      EXPECT_LT((walker->center() - point).norm(), 12.0);
    }
  }
  // They are there most of the time.
  EXPECT_GT(seen, 0.9 * 12 * static_cast<double>(robot.size()));
}

TEST(Crowd, WalksSmoothlyUnlessSomeoneElseComes) {
  const std::vector<MotionStep> robot = ThereAndBack();
  int jumps = 0, walking = 0, steps = 0;
  for (const Walk& walk : WalkAbout(Corridor(), robot, kRadiusM, 12, 3)) {
    for (std::size_t i = 1; i < robot.size(); ++i) {
      const auto from = walk.At(robot[i - 1].time_s), to = walk.At(robot[i].time_s);
      if (!from || !to) continue;
      ++steps;
      const double moved_m = (to->center() - from->center()).norm();
      if (moved_m > 1.8 * kStepS + 1e-9) {
        ++jumps;
        continue;
      }
      walking += moved_m > 0.4 * kStepS;
      const double turned_rad =
          backend::WrapAngle(to->world_T_center.theta - from->world_T_center.theta);
      EXPECT_LE(std::abs(turned_rad), 3.0 * kStepS + 1e-9);
      // Half-way between two steps a walker is half-way between the two places.
      const Eigen::Vector2d middle = (from->center() + to->center()) / 2.0;
      const auto between = walk.At((robot[i - 1].time_s + robot[i].time_s) / 2.0);
      EXPECT_NEAR((between->center() - middle).norm(), 0.0, 1e-6);
    }
  }
  EXPECT_GT(walking, 0.7 * steps);
  EXPECT_LT(jumps, 12 * 10);
}

TEST(Crowd, DependsOnTheSeedAlone) {
  const std::vector<MotionStep> robot = ThereAndBack();
  const auto at_10_s = [&](std::uint64_t seed) {
    return WalkAbout(Corridor(), robot, kRadiusM, 1, seed).front().At(10.0).value().center();
  };
  EXPECT_EQ(at_10_s(1), at_10_s(1));
  EXPECT_NE(at_10_s(1), at_10_s(2));
}

}  // namespace
}  // namespace gmapping_spa::simulation::crowd_test
