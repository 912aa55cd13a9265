// SPDX-License-Identifier: BSD-3-Clause
// The worlds of the folder that belong to no experiment of the paper.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "experiments/simulation/robot_motion.h"
#include "experiments/simulation/scene.h"

namespace gmapping_spa::simulation {
namespace {

std::string InWorlds(const std::string& file) { return std::string(WORLDS_FOLDER "/") + file; }

World Read(const std::string& name) { return World(ReadWorldRaster(InWorlds(name + ".yaml"))); }

// Drives the tours at the speed and, in m, returns how long they are; tells what it touches.
double PathLength(const World& world, const std::string& path, double max_speed_m_s, bool reverse) {
  constexpr double kRobotRadiusM = 0.5, kStepsPerS = 20.0;
  WayPointFollowerOptions options;
  options.max_speed_m_s = max_speed_m_s;
  options.reverse = reverse;
  double length_m = 0.0;
  for (const MotionStep& step :
       DriveTours(ReadTours(InWorlds(path + ".path.yaml")), options, kStepsPerS, 1.0)) {
    length_m += std::abs(step.after.linear_m_s) / kStepsPerS;
    if (step.carried) continue;
    const auto contact = world.FindContact(step.world_T_robot.translation(), kRobotRadiusM);
    EXPECT_FALSE(contact) << "at " << step.world_T_robot.translation().transpose();
    if (contact) break;
  }
  return length_m;
}

struct Tour {
  const char* world;
  const char* path;
  double length_m;
};
class Worlds : public testing::TestWithParam<Tour> {};

TEST_P(Worlds, ToursTouchNothingAndAreAsLongAsTheirFilesSay) {
  const World world = Read(GetParam().world);
  for (const double max_speed_m_s : {0.7, 2.0}) {
    for (const bool reverse : {false, true}) {
      EXPECT_NEAR(PathLength(world, GetParam().path, max_speed_m_s, reverse), GetParam().length_m,
                  0.02 * GetParam().length_m + 1.0)
          << max_speed_m_s << reverse;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Worlds,
                         testing::Values(Tour{"corridor_with_doors", "corridor_with_doors", 48.0},
                                         Tour{"plain_corridor", "plain_corridor", 60.0},
                                         Tour{"empty_hall", "empty_hall", 124.0},
                                         Tour{"pillared_gallery", "pillared_gallery", 238.0},
                                         Tour{"twin_corridors", "twin_corridors", 231.0},
                                         Tour{"campus", "campus", 1550.0},
                                         Tour{"warehouse", "warehouse", 306.0},
                                         Tour{"paper_building", "paper_building.carried", 122.0}));

TEST(TwinCorridors, AreTheSameWhenTurnedAboutTheirMiddle) {
  const World world = Read("twin_corridors");
  const map::TrinaryMap& raster = world.raster();
  for (int row = 0; row < raster.height; ++row) {
    for (int column = 0; column < raster.width; ++column) {
      ASSERT_EQ(raster.at(column, row),
                raster.at(raster.width - 1 - column, raster.height - 1 - row))
          << column << ' ' << row;
    }
  }
}

TEST(PillaredGallery, LooksTheSameFromOnePillarToTheNext) {
  const World world = Read("pillared_gallery");
  for (double angle_rad = -std::numbers::pi; angle_rad < std::numbers::pi; angle_rad += 0.01) {
    const auto here = world.CastRay({15.0, 2.5}, angle_rad, 5.6);
    const auto there = world.CastRay({15.8, 2.5}, angle_rad, 5.6);
    ASSERT_EQ(here.has_value(), there.has_value()) << angle_rad;
    EXPECT_NEAR(here.value_or(0.0), there.value_or(0.0), 1e-6);
  }
}

TEST(Warehouse, LooksTheSameFromOneAisleToTheNext) {
  const World world = Read("warehouse");
  for (double angle_rad = -std::numbers::pi; angle_rad < std::numbers::pi; angle_rad += 0.01) {
    const auto here = world.CastRay({6.0, 14.0}, angle_rad, 8.0);
    const auto there = world.CastRay({9.0, 14.0}, angle_rad, 8.0);
    ASSERT_EQ(here.has_value(), there.has_value()) << angle_rad;
    EXPECT_NEAR(here.value_or(0.0), there.value_or(0.0), 1e-6);
  }
}

TEST(EmptyHall, ItsMiddleIsOutOfSightOfAShortRange) {
  const World world = Read("empty_hall");
  EXPECT_FALSE(world.FindContact({15.5, 10.5}, 5.6));
}

}  // namespace
}  // namespace gmapping_spa::simulation
