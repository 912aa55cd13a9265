// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::simulation::world_test {
namespace {

using map::CellState;
using testing::HasSubstr;

std::string WriteFile(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

World WorldOf(const std::string& yaml) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return World(ReadWorldRaster(WriteFile(std::string("world_") + test->name() + ".yaml", yaml)));
}

std::string ErrorOf(const std::string& yaml) {
  try {
    WorldOf(yaml);
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(message.rfind(".yaml") + 5);
  }
  return "no error";
}

// Distance along a ray to an axis-aligned rectangle, from outside, by the slab method.
double RangeToBox(const Eigen::Vector2d& origin, double angle_rad, const Eigen::Vector2d& min,
                  const Eigen::Vector2d& max) {
  const Eigen::Vector2d direction(std::cos(angle_rad), std::sin(angle_rad));
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (const int axis : {0, 1}) {
    const double a = (min[axis] - origin[axis]) / direction[axis];
    const double b = (max[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

constexpr const char* kTwoBoxes =
    "size: [10, 8]\nresolution: 0.025\nboxes:\n  - [2, 1, 3.5, 2]\n  - [6, 4, 6.5, 7.25]\n";

TEST(World, RaysMeetBoxesAtTheAnalyticDistance) {
  const World world = WorldOf(kTwoBoxes);
  int hits = 0;
  for (const Eigen::Vector2d& origin : {Eigen::Vector2d(4.7, 3.1), Eigen::Vector2d(0.37, 5.77)}) {
    for (int i = 0; i < 1000; ++i) {
      const double angle_rad = -4.0 + 0.00801 * i;
      const double expected = std::min(RangeToBox(origin, angle_rad, {2, 1}, {3.5, 2}),
                                       RangeToBox(origin, angle_rad, {6, 4}, {6.5, 7.25}));
      const std::optional<double> range_m = world.CastRay(origin, angle_rad, 30.0);
      ASSERT_EQ(range_m.has_value(), std::isfinite(expected)) << "angle " << angle_rad;
      if (range_m) {
        EXPECT_NEAR(*range_m, expected, 1e-9) << "angle " << angle_rad;
      }
      hits += range_m.has_value();
    }
  }
  EXPECT_GT(hits, 200);
}

TEST(World, RaysMeetTheNearestOfScatteredCells) {
  map::TrinaryMap raster{60, 50, 0.1, -1.0, 2.0, std::vector<CellState>(3000, CellState::kFree)};
  std::vector<Eigen::Vector2d> corners;
  backend::CounterRandom random(1, 0);
  for (int row = 0; row < raster.height; ++row) {
    for (int column = 0; column < raster.width; ++column) {
      // More in the upper part: both open space and crowds.
      if (random.Uniform() > 0.002 * row) continue;
      raster.at(column, row) = CellState::kOccupied;
      corners.emplace_back(-1.0 + 0.1 * column, 2.0 + 0.1 * row);
    }
  }
  const World world(raster);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d origin(-1.0 + 6.0 * random.Uniform(), 2.0 + 5.0 * random.Uniform());
    const double angle_rad = 7.0 * random.Uniform();
    double expected = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& corner : corners) {
      expected = std::min(
          expected, RangeToBox(origin, angle_rad, corner, corner + Eigen::Vector2d::Constant(0.1)));
    }
    const std::optional<double> range_m = world.CastRay(origin, angle_rad, 30.0);
    ASSERT_EQ(range_m.has_value(), std::isfinite(expected)) << i;
    if (range_m) {
      EXPECT_NEAR(*range_m, expected, 1e-9) << i;
    }
    hits += range_m.has_value();
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 1900);
}

// Past a box two cells beside it, so that the ray counts edges there, and skips what is clear as
// soon as it is on the far side of the edge.
TEST(World, ARayThatLeavesTheEdgeItRunsAlongByLessThanRoundingEnds) {
  const World world = WorldOf(
      "size: [6, 6]\nresolution: 0.025\nboxes: [[3, 2.55, 3.2, 3], [3.3, 2.575, 3.5, 3], "
      "[5, 0, 5.1, 6]]\n");
  for (const double angle_rad : {-1e-17, 1e-17, -1e-300}) {
    EXPECT_NEAR(world.CastRay({1.0, 2.5}, angle_rad, 30.0).value(), 4.0, 1e-9) << angle_rad;
  }
}

TEST(World, RaysAlongTheAxesAreExact) {
  const World world = WorldOf(kTwoBoxes);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(world.CastRay({1.0, 1.5}, 0.0, 30.0).value(), 1.0, 1e-12);
  EXPECT_NEAR(world.CastRay({5.0, 1.5}, pi, 30.0).value(), 1.5, 1e-12);
  EXPECT_NEAR(world.CastRay({3.0, 0.25}, pi / 2.0, 30.0).value(), 0.75, 1e-12);
  EXPECT_NEAR(world.CastRay({6.25, 7.75}, -pi / 2.0, 30.0).value(), 0.5, 1e-12);
  // From the very corner of a cell.
  EXPECT_NEAR(world.CastRay({1.5, 1.5}, 0.0, 30.0).value(), 0.5, 1e-12);
}

TEST(World, RaysEndAtTheirRangeAndAtTheEdge) {
  const World world = WorldOf(kTwoBoxes);
  EXPECT_TRUE(world.CastRay({1.0, 1.5}, 0.0, 1.001).has_value());
  EXPECT_FALSE(world.CastRay({1.0, 1.5}, 0.0, 0.999).has_value());
  EXPECT_FALSE(world.CastRay({1.0, 1.5}, 3.0, 1000.0).has_value());
  EXPECT_FALSE(world.CastRay({-1.0, 1.5}, 0.0, 1000.0).has_value());
  EXPECT_EQ(world.CastRay({2.5, 1.5}, 0.0, 30.0), 0.0);
}

TEST(World, FindsTheContactOfADisc) {
  const World world = WorldOf(kTwoBoxes);
  EXPECT_FALSE(world.FindContact({1.49, 1.5}, 0.5).has_value());
  const auto side = world.FindContact({1.6, 1.5}, 0.5);
  ASSERT_TRUE(side.has_value());
  EXPECT_NEAR(side->x(), 2.0, 1e-9);
  // Near a corner it is the distance to the corner that counts: 0.5 * sqrt(2).
  EXPECT_FALSE(world.FindContact({4.0, 2.5}, 0.707).has_value());
  EXPECT_TRUE(world.FindContact({4.0, 2.5}, 0.708).has_value());
  // The world ends at its edge.
  EXPECT_TRUE(world.FindContact({0.4, 4.0}, 0.5).has_value());
  EXPECT_TRUE(world.FindContact({8.0, 7.6}, 0.5).has_value());
  EXPECT_TRUE(world.FindContact({-3.0, 4.0}, 0.5).has_value());
}

TEST(World, ShapesAreDrawnOverTheImage) {
  WriteFile("world_image.pgm", std::string("P5\n4 2\n255\n\xfe\xfe\xfe\0\xcd\xfe\xfe\xfe", 19));
  const World world = WorldOf(
      "image: world_image.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\nboxes: [[-0.5, 2, 0, 2.5]]\n");
  EXPECT_NEAR(world.CastRay({-0.75, 2.75}, 0.0, 9.0).value(), 1.25, 1e-12);
  EXPECT_NEAR(world.CastRay({-0.75, 2.25}, 0.0, 9.0).value(), 0.25, 1e-12);
  // What the image does not know is empty.
  EXPECT_EQ(world.raster().at(0, 0), CellState::kUnknown);
  EXPECT_FALSE(world.CastRay({-0.75, 2.25}, 3.0, 9.0).has_value());
}

TEST(World, HasTheShapesOfItsFile) {
  const World world = WorldOf(
      "size: [4, 3]\nresolution: 0.1\nboxes: [[0, 0, 1, 1]]\nwalls: [[2, 0, 2, 1, 0.2]]\n"
      "discs: [[3, 2, 0.5]]\n");
  EXPECT_NEAR(world.CastRay({0.5, 2.05}, 0.0, 9.0).value(), 2.0, 1e-9);
  EXPECT_NEAR(world.CastRay({1.5, 0.5}, 0.0, 9.0).value(), 0.4, 1e-9);
  EXPECT_NEAR(world.CastRay({1.5, 0.5}, std::numbers::pi, 9.0).value(), 0.5, 1e-9);
}

TEST(World, BadFilesAreNamedByLine) {
  const std::string head = "size: [4, 3]\nresolution: 0.1\n";
  ASSERT_EQ(ErrorOf(head), "no error");
  EXPECT_THAT(ErrorOf(head + "boxs: []\n"), HasSubstr(":3: expected one of the keys size, "));
  EXPECT_THAT(ErrorOf(head + "boxs: []\n"), HasSubstr("found 'boxs'"));
  EXPECT_EQ(ErrorOf(head + "boxes:\n  - [0, 0, 1]\n"),
            ":4: expected a box [x_min, y_min, x_max, y_max], found a list of 3");
  EXPECT_EQ(ErrorOf("resolution: 0.1\n"), ": expected the key 'size', found none");
  EXPECT_THAT(ErrorOf("size: [4, 3]\nresolution: 0\n"), HasSubstr(":1: expected a size"));
  EXPECT_THAT(ErrorOf("size: [1e9, 1e9]\nresolution: 0.1\n"), HasSubstr(":1: expected a size"));
  EXPECT_THAT(ErrorOf("size: [4, 3]\nimage: a.pgm\nresolution: 0\n"),
              HasSubstr(":1: expected one of the keys image, "));
}

}  // namespace
}  // namespace gmapping_spa::simulation::world_test
