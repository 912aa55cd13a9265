// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/truth_map.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace gmapping_spa::simulation {
namespace {

using map::CellState;

// '#' solid, '.' empty; the first line is the top.
World WorldOf(const std::vector<std::string>& lines) {
  map::TrinaryMap raster;
  raster.width = static_cast<int>(lines[0].size());
  raster.height = static_cast<int>(lines.size());
  raster.resolution_m = 1.0;
  raster.cells.resize(static_cast<std::size_t>(raster.width) * raster.height);
  for (int row = 0; row < raster.height; ++row) {
    for (int column = 0; column < raster.width; ++column) {
      raster.at(column, row) =
          lines[raster.height - 1 - row][column] == '#' ? CellState::kOccupied : CellState::kFree;
    }
  }
  return World(raster);
}

std::vector<std::string> Lines(const map::TrinaryMap& map) {
  std::vector<std::string> lines;
  for (int row = map.height - 1; row >= 0; --row) {
    std::string line;
    for (int column = 0; column < map.width; ++column) {
      line += "?.#"[static_cast<int>(map.at(column, row))];
    }
    lines.push_back(line);
  }
  return lines;
}

const std::vector<std::string> kHouse = {"########",  //
                                         "########",  //
                                         "##...#.#",  //
                                         "##.#.#.#",  //
                                         "##...###",  //
                                         "########"};

TEST(TruthMap, ShowsWhatCanBeReachedAndItsWalls) {
  // The inside of the thick wall and the closed room on the right are unknown.
  EXPECT_EQ(Lines(TruthMap(WorldOf(kHouse), {2.5, 1.5}, 1.0)),
            (std::vector<std::string>{"????????",  //
                                      "?#####??",  //
                                      "?#...#??",  //
                                      "?#.#.#??",  //
                                      "?#...#??",  //
                                      "?#####??"}));
}

TEST(TruthMap, CoarserCellsKeepTheWalls) {
  const map::TrinaryMap map = TruthMap(WorldOf(kHouse), {2.5, 1.5}, 2.0);
  EXPECT_EQ(map.resolution_m, 2.0);
  EXPECT_EQ(Lines(map), (std::vector<std::string>{"###?",  //
                                                  "###?",  //
                                                  "###?"}));
}

TEST(TruthMap, DoesNotLeakBetweenCorners) {
  EXPECT_EQ(Lines(TruthMap(WorldOf({".#", "#."}), {0.5, 1.5}, 1.0)),
            (std::vector<std::string>{".#", "#?"}));
}

TEST(TruthMap, RefusesABadStartOrResolution) {
  const World world = WorldOf(kHouse);
  EXPECT_THROW(TruthMap(world, {0.5, 0.5}, 1.0), std::runtime_error);
  EXPECT_THROW(TruthMap(world, {-1.0, 0.5}, 1.0), std::runtime_error);
  EXPECT_THROW(TruthMap(world, {2.5, 1.5}, 1.5), std::runtime_error);
  EXPECT_THROW(TruthMap(world, {2.5, 1.5}, 0.5), std::runtime_error);
}

TEST(TruthMap, WhatWasAddedStandsAlone) {
  const std::vector<std::string> with_box = {"######",  //
                                             "#..#.#",  //
                                             "#....#",  //
                                             "######"};
  const std::vector<std::string> without = {"######",  //
                                            "#....#",  //
                                            "#....#",  //
                                            "######"};
  const auto truth_of = [](const std::vector<std::string>& lines, double resolution_m) {
    return TruthMap(WorldOf(lines), {1.5, 1.5}, resolution_m);
  };
  EXPECT_EQ(Lines(Added(truth_of(with_box, 1.0), truth_of(without, 1.0))),
            (std::vector<std::string>{"??????",  //
                                      "?..#.?",  //
                                      "?....?",  //
                                      "??????"}));
  EXPECT_THROW(Added(truth_of(with_box, 1.0), truth_of(without, 2.0)), std::invalid_argument);
}

}  // namespace
}  // namespace gmapping_spa::simulation
