// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/map_structure.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;
using map::TrinaryMap;

// A room of 40 x 30 cells with a wall of one cell around it, unknown outside.
TrinaryMap Room() {
  TrinaryMap map = UnknownMap(60, 50);
  Fill(10, 10, 50, 40, CellState::kOccupied, &map);
  Fill(11, 11, 49, 39, CellState::kFree, &map);
  return map;
}

TEST(MapStructure, OfARoomIsFourCornersAndOneArea) {
  const MapStructure structure = MeasureStructure(Room());
  EXPECT_EQ(structure.occupied_cells, 2 * 40 + 2 * 28);
  EXPECT_EQ(structure.corners, 4);
  EXPECT_EQ(structure.enclosed_areas, 1);
}

TEST(MapStructure, IsTheSameWhenTheMapEndsAtTheWalls) {
  TrinaryMap map = UnknownMap(40, 30);
  Fill(0, 0, 40, 30, CellState::kOccupied, &map);
  Fill(1, 1, 39, 29, CellState::kFree, &map);
  EXPECT_EQ(MeasureStructure(map).corners, 4);
  EXPECT_EQ(MeasureStructure(map).enclosed_areas, 1);
}

TEST(MapStructure, OfADividedRoomIsTwoAreas) {
  TrinaryMap map = Room();
  Fill(30, 10, 31, 40, CellState::kOccupied, &map);
  EXPECT_EQ(MeasureStructure(map).enclosed_areas, 2);
}

TEST(MapStructure, AnOpenRoomEnclosesNothingButHolesOfTwoCellsAreClosed) {
  TrinaryMap map = Room();
  Fill(30, 10, 32, 11, CellState::kFree, &map);
  EXPECT_EQ(MeasureStructure(map).enclosed_areas, 1);
  Fill(30, 10, 33, 11, CellState::kFree, &map);
  EXPECT_EQ(MeasureStructure(map).enclosed_areas, 0);
}

TEST(MapStructure, ADoubledWallEnclosesAPocketAndHasCornersOfItsOwn) {
  TrinaryMap map = Room();
  Fill(10, 15, 35, 16, CellState::kOccupied, &map);
  Fill(35, 10, 36, 16, CellState::kOccupied, &map);
  const MapStructure structure = MeasureStructure(map);
  EXPECT_EQ(structure.enclosed_areas, 2);
  EXPECT_GT(structure.corners, 4);
}

TEST(MapStructure, NoiseOfSingleCellsAlongAWallIsNoCorner) {
  TrinaryMap map = Room();
  for (int column = 14; column < 46; column += 8) map.at(column, 11) = CellState::kOccupied;
  EXPECT_EQ(MeasureStructure(map).corners, 4);
}

TEST(MapStructure, OfAnEmptyMapIsNothing) {
  const MapStructure structure = MeasureStructure(TrinaryMap{});
  EXPECT_EQ(structure.occupied_cells, 0);
  EXPECT_EQ(structure.enclosed_areas, 0);
  EXPECT_EQ(structure.corners, 0);
}

}  // namespace
}  // namespace gmapping_spa::metrics
