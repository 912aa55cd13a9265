// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/closing.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;

TEST(Closing, FillsGapsOfTwiceItsCellsAndNoLargerOnes) {
  for (const int cells : {1, 2, 3}) {
    for (const int gap : {2 * cells, 2 * cells + 1}) {
      map::TrinaryMap map = UnknownMap(40, 20);
      Fill(10, 10, 30, 11, CellState::kOccupied, &map);
      Fill(16, 10, 16 + gap, 11, CellState::kFree, &map);
      const map::TrinaryMap closed = Closed(map, cells);
      EXPECT_EQ(closed.at(17, 10), gap > 2 * cells ? CellState::kFree : CellState::kOccupied);
      EXPECT_EQ(closed.at(9, 10), CellState::kUnknown);
      EXPECT_EQ(closed.at(20 + cells, 11), CellState::kUnknown);
    }
  }
}

TEST(Closing, OfASolidIsTheSolidAndWhatIsFreeStaysFree) {
  map::TrinaryMap map = UnknownMap(20, 20);
  Fill(0, 0, 20, 10, CellState::kFree, &map);
  Fill(5, 5, 12, 12, CellState::kOccupied, &map);
  EXPECT_EQ(Closed(map, 2).cells, map.cells);
}

TEST(Closing, AFrameLeavesPointsWhereTheyAre) {
  map::TrinaryMap map = UnknownMap(4, 3);
  map.at(1, 2) = CellState::kOccupied;
  const map::TrinaryMap framed = Framed(map, 5);
  EXPECT_EQ(framed.width, 14);
  EXPECT_EQ(framed.height, 13);
  EXPECT_EQ(framed.at(6, 7), CellState::kOccupied);
  EXPECT_DOUBLE_EQ(framed.origin_x_m, -0.25);
  EXPECT_DOUBLE_EQ(framed.origin_y_m, -0.25);
}

}  // namespace
}  // namespace gmapping_spa::metrics
