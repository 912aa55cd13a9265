// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/map_comparison.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics::map_comparison_test {
namespace {

using map::CellState;
using map::TrinaryMap;

constexpr double kNear = 1e-9;

// A room of 9 x 5 cells without its wall of one cell; 28 edges face it.
TrinaryMap Room() {
  TrinaryMap map = UnknownMap(11, 7);
  Fill(0, 0, 11, 7, CellState::kOccupied, &map);
  Fill(1, 1, 10, 6, CellState::kFree, &map);
  return map;
}

// Seen from the middle of the room.
MapComparison Compare(const TrinaryMap& map, const backend::SE2& truth_T_map = {}) {
  const TrinaryMap truth = Room();
  return CompareMaps(truth, LookAround(truth, {{0.0, {0.275, 0.175, 0.0}}}, 5.0), map, truth_T_map);
}

void ExpectNoError(const MapComparison& comparison) {
  ASSERT_EQ(comparison.surface.size(), 28u);
  ASSERT_EQ(comparison.elements.size(), 28u);
  int straight = 0;
  for (const ComparedElement& element : comparison.elements) {
    EXPECT_NEAR(element.distance_m, 0.0, kNear);
    if (element.bands.empty()) continue;
    ++straight;
    EXPECT_NEAR(element.bands[0].begin_m, -0.05, kNear);
    EXPECT_NEAR(element.bands[0].end_m, 0.0, kNear);
  }
  EXPECT_EQ(straight, 2 * 3) << "where no corner is within three cells";
  ASSERT_EQ(comparison.cells.size(), 32u);
  for (const ComparedCell& cell : comparison.cells) {
    EXPECT_NEAR(cell.distance_m, 0.0, kNear);
    EXPECT_FALSE(cell.in_seen_space);
  }
  EXPECT_EQ(comparison.seen_cells, 45);
  EXPECT_EQ(comparison.known_cells, 45);
}

TEST(MapComparison, FindsTheTruthWhereItIsThoughItsFrameIsTurned) {
  ExpectNoError(Compare(Room()));
  TrinaryMap turned = UnknownMap(7, 11);
  for (int row = 0; row < 11; ++row) {
    for (int column = 0; column < 7; ++column) {
      turned.at(column, row) = Room().at(10 - row, column);
    }
  }
  ExpectNoError(Compare(turned, {0.55, 0.0, 0.5 * std::numbers::pi}));
}

TEST(MapComparison, CellsAreInTheFrameOfTheTruthByRows) {
  TrinaryMap map = UnknownMap(3, 2);
  map.at(2, 0) = map.at(0, 1) = map.at(1, 1) = CellState::kOccupied;
  map.at(0, 0) = CellState::kFree;
  const MapComparison comparison = Compare(map, {0.1, 0.15, 0.0});
  ASSERT_EQ(comparison.cells.size(), 3u);
  EXPECT_NEAR(comparison.cells[0].center.x(), 0.225, kNear);
  EXPECT_NEAR(comparison.cells[0].center.y(), 0.175, kNear);
  EXPECT_NEAR(comparison.cells[0].distance_m, 0.1, kNear) << "two cells to both long walls";
  EXPECT_NEAR(comparison.cells[1].center.x(), 0.125, kNear);
  EXPECT_NEAR(comparison.cells[1].distance_m, 0.05, kNear);
  EXPECT_TRUE(comparison.cells[1].in_seen_space);
  EXPECT_EQ(comparison.known_cells, 4) << "of six that the map has, two are unknown";
  EXPECT_EQ(comparison.seen_cells, 45);
}

TEST(MapComparison, DistancesEndAtTheCap) {
  TrinaryMap map = UnknownMap(1, 1);
  for (const ComparedElement& element : Compare(map).elements) {
    EXPECT_EQ(element.distance_m, kDistanceCap_m);
    EXPECT_TRUE(element.bands.empty());
  }
  map.at(0, 0) = CellState::kOccupied;
  const MapComparison far = Compare(map, {9.0, 0.0, 0.0});
  EXPECT_EQ(far.cells.at(0).distance_m, kDistanceCap_m);
  EXPECT_FALSE(far.cells.at(0).in_seen_space);
  EXPECT_NEAR(Compare(map, {1.0, 0.15, 0.0}).cells.at(0).distance_m, 0.5, kNear);
}

}  // namespace
}  // namespace gmapping_spa::metrics::map_comparison_test
