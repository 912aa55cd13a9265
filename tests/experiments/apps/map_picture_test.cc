// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/map_picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/experiments/apps/picture.h"

namespace gmapping_spa::apps::map_picture_test {
namespace {

using backend::Trajectory;
using map::CellState;
using map::TrinaryMap;

constexpr std::uint32_t kWhite = 0xffffff, kBlack = 0x000000, kGrey = 0xcdcdcd;

// A room of free cells in the middle of unknown ones, with a wall on its left.
TrinaryMap Room(int size, double resolution_m) {
  TrinaryMap map{size, size, resolution_m, -3.0, 7.0, {}};
  map.cells.assign(static_cast<std::size_t>(size) * size, CellState::kUnknown);
  for (int row = size / 4; row < 3 * size / 4; ++row) {
    for (int column = size / 4; column < 3 * size / 4; ++column) {
      map.at(column, row) = column == size / 4 ? CellState::kOccupied : CellState::kFree;
    }
  }
  return map;
}

Picture Draw(const TrinaryMap& map, const Trajectory& trajectory, const Stretches& stretches = {}) {
  const std::string path = testing::TempDir() + "map_picture_" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() + ".png";
  WriteMapPicture(map, trajectory, path, stretches);
  return ReadPicture(path);
}

TEST(MapPicture, IsCroppedToKnownCellsAndEnlarged) {
  // 4 m x 4 m are known; with the margin, 6 m become 800 pixels.
  const Picture picture = Draw(Room(80, 0.1), {});
  EXPECT_EQ(picture.width, 800);
  EXPECT_GE(picture.height, 800);
  EXPECT_EQ(picture.at(5, 5), kGrey);
  EXPECT_EQ(picture.at(140, 400), kBlack);
  EXPECT_EQ(picture.at(400, 400), kWhite);
  EXPECT_EQ(picture.at(795, 400), kGrey);
}

TEST(MapPicture, ReducesLargeMapsAndKeepsThinWalls) {
  const Picture picture = Draw(Room(12000, 0.01), {});
  EXPECT_EQ(picture.width, 2000);
  bool wall = false;
  for (int x = 0; x < 200; ++x) wall |= picture.at(x, 1000) == kBlack;
  EXPECT_TRUE(wall);
}

// Along y = 11 m, the middle of the room, from x = -0.5 to 2.5 m in 30 s: row 400.
Trajectory WayThroughTheRoom() {
  Trajectory trajectory;
  for (int i = 0; i <= 300; ++i) trajectory.push_back({0.1 * i, {-0.5 + 0.01 * i, 11.0, 0.0}});
  return trajectory;
}

int ColumnOf(double x_m) { return static_cast<int>((x_m + 2.0) * 800.0 / 6.0); }

TEST(MapPicture, ShowsTheTrajectoryFromBlueToRed) {
  const Picture picture = Draw(Room(80, 0.1), WayThroughTheRoom());
  const auto color_at_x = [&](double x_m) { return picture.at(ColumnOf(x_m), 400); };
  const std::uint32_t start = color_at_x(-0.5), early = color_at_x(-0.2), late = color_at_x(2.2);
  EXPECT_GT(start >> 8 & 0xff, start & 0xff) << "the start is green";
  EXPECT_GT(early & 0xff, early >> 16) << "early is blue";
  EXPECT_GT(late >> 16, late & 0xff) << "late is red";
  EXPECT_EQ(picture.at(400, 300), kWhite);
}

TEST(MapPicture, AmbiguousStretchesAreMagentaAndThick) {
  const Picture picture = Draw(Room(80, 0.1), WayThroughTheRoom(), {{"ambiguous", {{10, 15}}}});
  for (const int row : {398, 400, 401})
    EXPECT_EQ(picture.at(ColumnOf(0.75), row), 0xe600e6u) << row;
  EXPECT_NE(picture.at(ColumnOf(1.2), 400), 0xe600e6u) << "after it";
  EXPECT_EQ(picture.at(ColumnOf(1.2), 398), kWhite) << "thin again";
}

TEST(MapPicture, LostStretchesAreDashedInBlackOnWhite) {
  const Picture picture = Draw(Room(80, 0.1), WayThroughTheRoom(), {{"lost", {{10, 15}}}});
  int black = 0, white = 0, others = 0;
  for (int x = ColumnOf(0.55); x < ColumnOf(0.95); ++x) {
    const std::uint32_t color = picture.at(x, 400);
    ++(color == kBlack ? black : color == kWhite ? white : others);
  }
  EXPECT_GT(black, 15);
  EXPECT_GT(white, 10);
  EXPECT_LT(others, black) << "edges of dashes only";
}

TEST(MapPicture, AStretchOfASingleScanShows) {
  const Picture picture = Draw(Room(80, 0.1), WayThroughTheRoom(), {{"ambiguous", {{10, 10}}}});
  EXPECT_EQ(picture.at(ColumnOf(0.5), 400), 0xe600e6u);
}

TEST(MapPicture, LegendNamesTheKindsThatAreThere) {
  const auto colors_below = [](const Picture& picture) {
    std::set<std::uint32_t> colors;
    for (int y = picture.height - 44; y < picture.height; ++y) {
      for (int x = picture.width / 2; x < picture.width; ++x) colors.insert(picture.at(x, y));
    }
    return colors;
  };
  const Trajectory way = WayThroughTheRoom();
  EXPECT_EQ(colors_below(Draw(Room(80, 0.1), way, {{"lost", {}}})), std::set{kWhite});
  EXPECT_TRUE(colors_below(Draw(Room(80, 0.1), way, {{"lost", {{10, 15}}}})).contains(kBlack));
  EXPECT_TRUE(
      colors_below(Draw(Room(80, 0.1), way, {{"ambiguous", {{10, 15}}}})).contains(0xe600e6u));
}

TEST(MapPicture, StretchesBeyondTheTrajectoryDrawNothing) {
  EXPECT_NO_THROW(Draw(Room(80, 0.1), {}, {{"lost", {{10, 15}}}}));
  EXPECT_NO_THROW(Draw(Room(80, 0.1), WayThroughTheRoom(), {{"lost", {{-20, -10}, {90, 99}}}}));
}

TEST(MapPicture, SurvivesAnEmptyMapAndADivergedTrajectory) {
  EXPECT_NO_THROW(Draw({}, {}));
  EXPECT_NO_THROW(Draw(Room(80, 0.1), {{0.0, {}}, {1.0, {1e12, -1e12, 0.0}}}));
}

TEST(MapPicture, SaysWhichFileCannotBeWritten) {
  EXPECT_THROW(WriteMapPicture(Room(80, 0.1), {}, "/nowhere/map.png"), std::runtime_error);
}

TEST(MapPicture, NoticesAFullDevice) {
  EXPECT_THROW(WriteMapPicture(Room(80, 0.1), {}, "/dev/full"), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::apps::map_picture_test
