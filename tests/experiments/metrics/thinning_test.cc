// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/metrics/connected_cells.h"
#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;

int Occupied(const map::TrinaryMap& map) {
  return static_cast<int>(std::count(map.cells.begin(), map.cells.end(), CellState::kOccupied));
}

TEST(Thinning, LeavesTheMiddleOfABar) {
  map::TrinaryMap map = UnknownMap(40, 20);
  Fill(5, 8, 35, 11, CellState::kOccupied, &map);
  const map::TrinaryMap thin = Thinned(map);
  for (int column = 8; column < 32; ++column) {
    EXPECT_EQ(thin.at(column, 8), CellState::kFree);
    EXPECT_EQ(thin.at(column, 9), CellState::kOccupied);
    EXPECT_EQ(thin.at(column, 10), CellState::kFree);
  }
}

TEST(Thinning, LeavesThinLinesAsTheyAre) {
  map::TrinaryMap map = UnknownMap(40, 40);
  Fill(5, 5, 35, 6, CellState::kOccupied, &map);
  for (int i = 0; i < 20; ++i) map.at(10 + i, 10 + i) = CellState::kOccupied;
  EXPECT_EQ(Thinned(map).cells, map.cells);
}

TEST(Thinning, KeepsWhatIsConnected) {
  map::TrinaryMap map = UnknownMap(40, 40);
  Fill(5, 5, 35, 8, CellState::kOccupied, &map);
  Fill(18, 5, 21, 35, CellState::kOccupied, &map);
  const map::TrinaryMap thin = Thinned(map);
  EXPECT_EQ(ConnectedCells(thin).size(), 1U);
  EXPECT_NEAR(Occupied(thin), 30 + 30, 8);
}

}  // namespace
}  // namespace gmapping_spa::metrics
