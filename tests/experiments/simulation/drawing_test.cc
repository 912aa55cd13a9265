// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace gmapping_spa::simulation {
namespace {

using map::CellState;
using testing::HasSubstr;

map::TrinaryMap Empty(int width, int height, double resolution_m) {
  map::TrinaryMap raster{width, height, resolution_m, 0.0, 0.0, {}};
  raster.cells.assign(static_cast<std::size_t>(width) * height, CellState::kFree);
  return raster;
}

double SolidAreaM2(const map::TrinaryMap& raster) {
  std::size_t cells = 0;
  for (const CellState state : raster.cells) cells += state == CellState::kOccupied;
  return static_cast<double>(cells) * raster.resolution_m * raster.resolution_m;
}

TEST(Draw, BoxEdgesOnCellEdgesAreNotMovedByRounding) {
  map::TrinaryMap raster = Empty(30, 10, 0.1);
  EXPECT_TRUE(Draw(Rectangle::FromCorners({0.3, 0.2}, {0.7, 0.9}), &raster));
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 30; ++column) {
      EXPECT_EQ(raster.at(column, row) == CellState::kOccupied,
                column >= 3 && column < 7 && row >= 2 && row < 9)
          << column << ' ' << row;
    }
  }
}

TEST(Draw, CoversTheCellsWhoseCentresLieInTheShape) {
  map::TrinaryMap raster = Empty(400, 300, 0.01);
  raster.origin_x_m = -1.0;
  EXPECT_TRUE(Draw(Rectangle{{1.0, 1.5, std::numbers::pi / 6.0}, {0.8, 0.25}}, &raster));
  EXPECT_NEAR(SolidAreaM2(raster), 1.6 * 0.5, 0.01);
  raster = Empty(400, 300, 0.01);
  EXPECT_TRUE(Draw(Disc{{2.0, 1.5}, 1.0}, &raster));
  EXPECT_NEAR(SolidAreaM2(raster), std::numbers::pi, 0.01);
  EXPECT_EQ(raster.at(200, 249), CellState::kOccupied);
  EXPECT_EQ(raster.at(200, 250), CellState::kFree);
}

TEST(Draw, ClipsAtTheEdgeAndTellsWhenNothingIsLeft) {
  map::TrinaryMap raster = Empty(40, 30, 0.1);
  EXPECT_TRUE(Draw(Rectangle::FromCorners({-1.0, -1.0}, {0.5, 0.5}), &raster));
  EXPECT_NEAR(SolidAreaM2(raster), 0.25, 1e-9);
  EXPECT_FALSE(Draw(Rectangle::FromCorners({5.0, 5.0}, {6.0, 6.0}), &raster));
  EXPECT_FALSE(Draw(Rectangle::FromCorners({2.0, 1.0}, {1.0, 2.0}), &raster));
  EXPECT_FALSE(Draw(Disc{{2.0, 2.0}, -1.0}, &raster));
}

// The raster of 4 m x 3 m with what the text lists drawn over it.
map::TrinaryMap Drawn(const std::string& yaml) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = testing::TempDir() + test->name() + ".yaml";
  std::ofstream(path) << yaml;
  map::TrinaryMap raster = Empty(400, 300, 0.01);
  DrawShapes(map::YamlFile(path), &raster);
  return raster;
}

TEST(DrawShapes, DrawsWallsFromEndToEnd) {
  const map::TrinaryMap raster = Drawn("walls:\n  - [1, 1, 3, 1, 0.2]\n");
  EXPECT_NEAR(SolidAreaM2(raster), 2.0 * 0.2, 1e-9);
  EXPECT_EQ(raster.at(100, 90), CellState::kOccupied);
  EXPECT_EQ(raster.at(299, 109), CellState::kOccupied);
  EXPECT_EQ(raster.at(100, 89), CellState::kFree);
  EXPECT_EQ(raster.at(99, 100), CellState::kFree);
  const map::TrinaryMap slanting = Drawn("walls:\n  - [1, 0.5, 3, 2, 0.1]\n");
  EXPECT_NEAR(SolidAreaM2(slanting), 2.5 * 0.1, 0.005);
}

std::string ErrorOf(const std::string& yaml) {
  try {
    Drawn(yaml);
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    return message.substr(message.rfind(".yaml") + 5);
  }
  return "no error";
}

TEST(DrawShapes, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(ErrorOf("boxes:\n  - [0, 0, 1, one]\n"),
            ":2: expected a box [x_min, y_min, x_max, y_max], found 'one' in it");
  EXPECT_THAT(ErrorOf("boxes:\n  - [0, 0, 1, 1]\n  - [2, 1, 1, 2]\n"),
              HasSubstr(":3: expected x_min < x_max"));
  EXPECT_THAT(ErrorOf("boxes:\n  - [5, 5, 6, 6]\n"), HasSubstr("a cell of the world"));
  EXPECT_EQ(ErrorOf("boxes: 3\n"), ":1: expected a list for 'boxes', found '3'");
  EXPECT_EQ(ErrorOf("walls:\n  - [0, 0, 1, 1]\n"),
            ":2: expected a wall [x1, y1, x2, y2, thickness], found a list of 4");
  EXPECT_THAT(ErrorOf("walls:\n  - [1, 1, 2, 2, -0.1]\n"), HasSubstr(":2: expected a thickness"));
  EXPECT_THAT(ErrorOf("discs:\n  - [1, 1]\n"), HasSubstr(":2: expected a disc [x, y, radius]"));
  EXPECT_THAT(ErrorOf("walls:\n  - [0, 0, 1e308, 0, 1]\n"), HasSubstr(":2: expected a thick"));
  EXPECT_THAT(ErrorOf("discs:\n  - [1, 1, 0]\n"), HasSubstr(":2: expected a radius above 0"));
}

}  // namespace
}  // namespace gmapping_spa::simulation
