// SPDX-License-Identifier: BSD-3-Clause
// Pictures that know where they lie.
#include "experiments/apps/world_file.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

#include "experiments/apps/map_cells.h"
#include "experiments/apps/map_picture.h"
#include "frontend/map/map_server_io.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace gmapping_spa::apps {
namespace {

using map::CellState;

// Occupied at its upper left, free at its lower right.
map::TrinaryMap SmallMap() {
  map::TrinaryMap map{3, 2, 0.25, -1.0, 10.0, {}};
  map.cells.assign(6, CellState::kUnknown);
  map.at(0, 1) = CellState::kOccupied;
  map.at(2, 0) = CellState::kFree;
  return map;
}

std::string Written(const PicturePlace& place) {
  std::ostringstream out;
  WriteWorldFile(place, out);
  return out.str();
}

TEST(WorldFile, TellsTheCenterOfTheUpperLeftPixel) {
  const TemporaryFolder folder;
  EXPECT_EQ(Written(WriteMapCells(SmallMap(), folder.Path("map.png"))),
            "0.25\n0\n0\n-0.25\n-0.875\n10.375\n");
}

TEST(WorldFile, MapCellsAreTheMapAsMapServerReadsIt) {
  const TemporaryFolder folder;
  const map::TrinaryMap map = SmallMap();
  WriteMapCells(map, folder.Path("map.png"));
  std::ostringstream yaml;
  map::WriteMapYaml(map, "map.png", yaml);
  const map::TrinaryMap again = map::ReadMap(folder.FileWith("map.yaml", yaml.str()));
  EXPECT_EQ(again.width, map.width);
  EXPECT_EQ(again.cells, map.cells);
}

// The only wall of a map that is drawn with a margin of 1 m and enlarged.
TEST(WorldFile, ThePictureForPeopleLiesWhereItsWallsAre) {
  const TemporaryFolder folder;
  const PicturePlace place = WriteMapPicture(SmallMap(), {}, folder.Path("map.png"));
  EXPECT_DOUBLE_EQ(place.left_x_m, -2.0);
  EXPECT_DOUBLE_EQ(place.top_y_m, 11.5);
  EXPECT_NEAR(place.pixel_m * 800, 2.75, 0.01);
}

TEST(WorldFile, MapCellsThatCannotBeWrittenAreOneLine) {
  const std::string message =
      MessageOf([] { WriteMapCells(SmallMap(), "/proc/none/map_cells.png"); });
  EXPECT_EQ(message.find("/proc/none/map_cells.png: expected to write a picture, found: "), 0u)
      << message;
}

}  // namespace
}  // namespace gmapping_spa::apps
