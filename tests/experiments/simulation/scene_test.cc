// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace gmapping_spa::simulation::scene_test {
namespace {

using testing::HasSubstr;

constexpr const char* kObstacles =
    "boxes: [[4, 1, 5, 2]]\npedestrian_size: [0.2, 0.4]\npedestrian_speed: 1\n"
    "pedestrian_way_points: [[2, 1.5], [2, 3.5]]\n";

// An empty world of 8 m x 5 m with the obstacles.
Scene SceneOf(const std::string& obstacles, bool walks) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = testing::TempDir() + "scene_" + test->name();
  std::ofstream(path + ".world.yaml") << "size: [8, 5]\nresolution: 0.05\n";
  std::ofstream(path + ".yaml") << obstacles;
  return Scene::Read(path + ".world.yaml", path + ".yaml", walks);
}

TEST(Scene, StandingObstaclesArePartOfTheWorld) {
  const Scene scene = SceneOf(kObstacles, false);
  EXPECT_FALSE(scene.pedestrian.has_value());
  EXPECT_NEAR(scene.world.CastRay({7.0, 1.5}, 3.14159265358979, 9.0).value(), 2.0, 1e-9);
  // Stands at the first way point, facing the second: up.
  EXPECT_NEAR(scene.world.CastRay({0.5, 1.5}, 0.0, 9.0).value(), 1.3, 1e-9);
  EXPECT_NEAR(scene.CastRay({0.5, 1.5}, 0.0, 9.0, 100.5).value(), 1.3, 1e-9);
}

TEST(Scene, AWalkingPedestrianIsSeenButNotPartOfTheWorld) {
  const Scene scene = SceneOf(kObstacles, true);
  EXPECT_NEAR(scene.world.CastRay({0.5, 1.5}, 0.0, 9.0).value(), 3.5, 1e-9);
  EXPECT_NEAR(scene.CastRay({0.5, 1.5}, 0.0, 9.0, 0.0).value(), 1.3, 1e-9);
  EXPECT_NEAR(scene.CastRay({0.5, 1.5}, 0.0, 9.0, 1.0).value(), 3.5, 1e-9);
  EXPECT_FALSE(scene.CastRay({0.5, 1.5}, 0.0, 1.2, 0.0).has_value());
  // What is nearer hides it.
  EXPECT_NEAR(scene.CastRay({5.5, 1.5}, 3.14159265358979, 9.0, 0.0).value(), 0.5, 1e-9);
}

TEST(Scene, TellsWhatADiscTouches) {
  const Scene scene = SceneOf(kObstacles, true);
  EXPECT_STREQ(scene.FindContact({3.7, 1.5}, 0.5, 0.0).value().what, "a wall");
  const Contact contact = scene.FindContact({2.6, 1.5}, 0.5, 0.0).value();
  EXPECT_STREQ(contact.what, "the pedestrian");
  EXPECT_NEAR(contact.world_point.x(), 2.2, 1e-9);
  EXPECT_FALSE(scene.FindContact({2.6, 1.5}, 0.5, 1.0).has_value());
}

std::string ErrorOf(const std::string& obstacles, bool walks) {
  try {
    SceneOf(obstacles, walks);
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    return message.substr(message.rfind(".yaml") + 5);
  }
  return "no error";
}

TEST(Scene, NamesTheLineOfWhatIsWrong) {
  const std::string size = "pedestrian_size: [0.2, 0.4]\n", speed = "pedestrian_speed: 1\n";
  const std::string way = "pedestrian_way_points: [[2, 1.5], [2, 3.5]]\n";
  EXPECT_EQ(ErrorOf(size + speed + way, true), "no error");
  EXPECT_EQ(ErrorOf("boxes: []\n", false), "no error");
  EXPECT_EQ(ErrorOf("boxes: []\n", true), ": expected the key 'pedestrian_size', found none");
  EXPECT_EQ(ErrorOf(size, false), ": expected the key 'pedestrian_speed', found none");
  EXPECT_THAT(ErrorOf("box: []\n", false), HasSubstr(":1: expected one of the keys boxes, "));
  EXPECT_THAT(ErrorOf("pedestrian_size: [0.2, 0]\n" + speed + way, true),
              HasSubstr(":1: expected"));
  EXPECT_THAT(ErrorOf(size + "pedestrian_speed: -1\n" + way, true), HasSubstr(":2: expected"));
  EXPECT_THAT(ErrorOf(size + speed + "pedestrian_way_points: [[20, 20], [20, 21]]\n", false),
              HasSubstr(":3: expected a cell of the world"));
}

TEST(Scene, WithoutObstaclesNobodyCanWalk) {
  const std::string path = testing::TempDir() + "scene_alone.yaml";
  std::ofstream(path) << "size: [8, 5]\nresolution: 0.05\n";
  EXPECT_FALSE(Scene::Read(path, "", false).pedestrian.has_value());
  EXPECT_THROW(Scene::Read(path, "", true), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::simulation::scene_test
