// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/tile_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace gmapping_spa::view {
namespace {

using map::CellState;
using ::testing::SizeIs;

map::TrinaryMap MapAt(int first_x, int first_y, int width, int height) {
  map::TrinaryMap map{width, height, 0.05, 0.05 * first_x, 0.05 * first_y, {}};
  map.cells.assign(static_cast<std::size_t>(width) * height, CellState::kUnknown);
  return map;
}

TEST(TileImage, ShowsThePartOfTheBeamsThatEndedInACell) {
  constexpr std::uint16_t kMost = std::numeric_limits<std::uint16_t>::max();
  map::Tile tile;
  tile.cell(0, 0) = {.hits = 0, .visits = 7};
  tile.cell(3, 2) = {.hits = 2, .visits = 3};
  tile.cell(15, 15) = {.hits = kMost, .visits = kMost};
  const TileImage image = ImageOf(tile);
  EXPECT_EQ(image[0], 0);
  EXPECT_EQ(image[2 * 16 + 3], 66) << "rows from the smallest y up";
  EXPECT_EQ(image[255], 100);
  EXPECT_EQ(std::ranges::count(image, kUnknownCell), 253);
  const map::Tile never_seen;
  EXPECT_EQ(ImageOf(never_seen), UnknownImage());
}

TEST(TileImages, OfAFinishedMapLieWhereItsOriginSays) {
  map::TrinaryMap map = MapAt(-17, 15, 20, 2);
  map.at(0, 0) = CellState::kOccupied;  // cell -17, 15
  map.at(1, 1) = CellState::kFree;      // cell -16, 16
  map.at(17, 1) = CellState::kFree;     // cell 0, 16
  const TileImages images = ImagesOf(map);
  ASSERT_THAT(images, SizeIs(3));
  EXPECT_EQ(images.at({-2, 0})[15 * 16 + 15], 100);
  EXPECT_EQ(images.at({-1, 1})[0], 0);
  EXPECT_EQ(images.at({0, 1})[0], 0);
  EXPECT_EQ(images.at({0, 1})[1], kUnknownCell);
}

TEST(TileImages, OfUnknownSpaceAreNone) { EXPECT_TRUE(ImagesOf(MapAt(0, 0, 40, 40)).empty()); }

TEST(TileImages, LieAtTheNearestCellWhereTheOriginIsNotAtOne) {
  map::TrinaryMap map = MapAt(0, 0, 1, 1);
  map.at(0, 0) = CellState::kOccupied;
  map.origin_x_m = 3 * 0.05 - 1e-9;
  map.origin_y_m = -0.049;
  const TileImages images = ImagesOf(map);
  ASSERT_THAT(images, SizeIs(1));
  EXPECT_EQ(images.at({0, -1})[15 * 16 + 3], 100);
}

}  // namespace
}  // namespace gmapping_spa::view
