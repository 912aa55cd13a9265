// SPDX-License-Identifier: BSD-3-Clause
// Hand-made maps with known errors.
#include "experiments/metrics/map_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "experiments/metrics/map_cells.h"
#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics::map_error_test {
namespace {

using map::CellState;
using map::TrinaryMap;

constexpr double kNear = 1e-9;
constexpr int kColumns = 60, kBottomWall = 19, kTopWall = 40;  // rows of wall; free between them

// A corridor of 3 m x 1 m with walls of one cell, open at both ends: 120 edges of surface, of which
// 112 are two cells or more from the ends.
TrinaryMap Corridor() {
  TrinaryMap map = UnknownMap(kColumns, 60);
  Fill(0, kBottomWall, kColumns, kTopWall + 1, CellState::kOccupied, &map);
  Fill(0, kBottomWall + 1, kColumns, kTopWall, CellState::kFree, &map);
  return map;
}

MapErrors ErrorsOf(const TrinaryMap& truth, const TrinaryMap& map,
                   const backend::SE2& truth_T_map = {}, double tolerance_m = 0.1) {
  backend::Trajectory poses;
  for (int i = 0; i < 12; ++i) poses.push_back({0.0, {0.13 + 0.25 * i, 1.51, 0.0}});
  return SummarizeErrors(CompareMaps(truth, LookAround(truth, poses, 30.0), map, truth_T_map),
                         tolerance_m);
}

void ExpectPerfect(const MapErrors& errors) {
  EXPECT_NEAR(errors.map_to_truth_m->mean, 0.0, kNear);
  EXPECT_NEAR(errors.map_to_truth_m->p95, 0.0, kNear);
  EXPECT_NEAR(errors.truth_to_map_m->mean, 0.0, kNear);
  EXPECT_NEAR(errors.shift_m->mean, 0.0, kNear);
  EXPECT_EQ(errors.precision, 1.0);
  EXPECT_EQ(errors.recall, 1.0);
  EXPECT_EQ(errors.iou, 1.0);
  EXPECT_EQ(errors.known, 1.0);
  EXPECT_EQ(errors.missing, 0.0);
  EXPECT_EQ(errors.extra, 0.0);
  EXPECT_EQ(errors.outside, 0.0);
}

TEST(MapError, OfTheTruthIsNoneAndItsBlurIsOneCell) {
  const MapErrors errors = ErrorsOf(Corridor(), Corridor());
  ExpectPerfect(errors);
  EXPECT_NEAR(errors.blur_m->mean, 0.05, kNear);
  EXPECT_NEAR(errors.blur_m->p95, 0.05, kNear);
  EXPECT_EQ(errors.occupied_cells, 120);
  EXPECT_EQ(errors.surface_elements, 120);
  EXPECT_EQ(errors.straight_elements, 112);
  EXPECT_EQ(errors.matched_elements, 112);
}

TEST(MapError, OfAShiftIsItsLength) {
  // Up by two cells: the upper wall is 0.1 m behind its surface, the lower one has its near side
  // 0.05 m in front.
  const MapErrors errors = ErrorsOf(Corridor(), Corridor(), {0.0, 0.1, 0.0});
  EXPECT_NEAR(errors.map_to_truth_m->mean, 0.075, kNear);
  EXPECT_NEAR(errors.map_to_truth_m->p95, 0.1, kNear);
  EXPECT_NEAR(errors.truth_to_map_m->mean, 0.075, kNear);
  EXPECT_NEAR(errors.truth_to_map_m->p95, 0.1, kNear);
  EXPECT_NEAR(errors.shift_m->mean, 0.075, kNear);
  EXPECT_NEAR(errors.shift_m->p95, 0.1, kNear);
  EXPECT_NEAR(errors.blur_m->mean, 0.05, kNear) << "shifted, not blurred";
  EXPECT_EQ(errors.precision, 0.5) << "only the lower wall is within one cell";
  EXPECT_EQ(errors.recall, 0.5);
  EXPECT_NEAR(*errors.iou, 1.0 / 3.0, kNear);
  EXPECT_EQ(errors.missing, 0.0);
  EXPECT_EQ(errors.extra, 0.0);
  const MapErrors strict = ErrorsOf(Corridor(), Corridor(), {0.0, 0.1, 0.0}, 0.06);
  EXPECT_EQ(strict.missing, 0.5);
  EXPECT_EQ(strict.extra, 0.0) << "0.05 m in free space is within the tolerance";
  EXPECT_EQ(ErrorsOf(Corridor(), Corridor(), {0.0, 0.1, 0.0}, 0.04).extra, 0.5);
}

TEST(MapError, OfAThickWallIsBlurBehindIt) {
  TrinaryMap map = Corridor();
  Fill(0, kBottomWall - 2, kColumns, kBottomWall, CellState::kOccupied, &map);
  const MapErrors errors = ErrorsOf(Corridor(), map);
  EXPECT_NEAR(errors.blur_m->mean, 0.5 * (0.15 + 0.05), kNear);
  EXPECT_NEAR(errors.blur_m->p95, 0.15, kNear);
  EXPECT_NEAR(errors.shift_m->mean, 0.0, kNear);
  EXPECT_NEAR(errors.map_to_truth_m->mean, (0.05 + 0.1) / 4.0, kNear);
  EXPECT_EQ(errors.precision, 0.75);
  EXPECT_EQ(errors.missing, 0.0);
  EXPECT_EQ(errors.extra, 0.0);
}

TEST(MapError, OfADoubledWallIsExtra) {
  TrinaryMap map = Corridor();
  Fill(0, kBottomWall + 7, kColumns, kBottomWall + 8, CellState::kOccupied, &map);  // 0.3 m inward
  const MapErrors errors = ErrorsOf(Corridor(), map);
  EXPECT_NEAR(*errors.extra, 1.0 / 3.0, kNear);
  EXPECT_NEAR(*errors.precision, 2.0 / 3.0, kNear);
  EXPECT_NEAR(errors.map_to_truth_m->mean, 0.3 / 3.0, kNear);
  EXPECT_NEAR(errors.map_to_truth_m->p95, 0.3, kNear);
  EXPECT_NEAR(errors.blur_m->mean, 0.05, kNear) << "two sharp walls";
  EXPECT_EQ(errors.recall, 1.0);
  EXPECT_EQ(errors.missing, 0.0);
}

TEST(MapError, OfAHoleIsMissingSurface) {
  TrinaryMap map = Corridor();
  Fill(20, kBottomWall, 40, kBottomWall + 1, CellState::kFree, &map);
  const MapErrors errors = ErrorsOf(Corridor(), map);
  // At each end of the hole two edges have their middles within 0.1 m of what is left, one within
  // a cell.
  EXPECT_NEAR(*errors.missing, 16.0 / 120.0, kNear);
  EXPECT_NEAR(*errors.recall, 102.0 / 120.0, kNear);
  EXPECT_EQ(errors.precision, 1.0);
  EXPECT_NEAR(*errors.iou, 102.0 / 120.0, kNear);
  // 0.025, 0.075, ... 0.475 m and back.
  EXPECT_NEAR(errors.truth_to_map_m->mean, 2.0 * 10.0 * 0.25 / 120.0, kNear);
  EXPECT_EQ(errors.matched_elements, 112 - 16) << "a stretch reaches two cells to both sides";
}

TEST(MapError, DoesNotCountARoomThatWasNeverSeen) {
  TrinaryMap truth = Corridor();
  Fill(10, 0, 30, 10, CellState::kOccupied, &truth);
  Fill(11, 1, 29, 9, CellState::kFree, &truth);
  ExpectPerfect(ErrorsOf(truth, Corridor()));
  EXPECT_EQ(ErrorsOf(truth, Corridor()).surface_elements, 120);
  ExpectPerfect(ErrorsOf(truth, truth));
}

TEST(MapError, OfACellWhereNothingCouldBeSeenIsOutside) {
  TrinaryMap map = Corridor();
  map.at(30, kBottomWall - 13) = CellState::kOccupied;  // 0.65 m behind the surface
  map.at(30, kBottomWall - 7) = CellState::kOccupied;   // 0.35 m
  const MapErrors errors = ErrorsOf(Corridor(), map);
  EXPECT_NEAR(*errors.outside, 1.0 / 122.0, kNear);
  EXPECT_NEAR(*errors.precision, 120.0 / 122.0, kNear);
  EXPECT_NEAR(errors.map_to_truth_m->mean, (0.65 + 0.35) / 122.0, kNear);
  EXPECT_EQ(errors.extra, 0.0);
}

TEST(MapError, OfAGhostFarFromAllWallsIsExtraAndNotOutside) {
  TrinaryMap truth = UnknownMap(kColumns, 60);
  Fill(0, 0, kColumns, 1, CellState::kOccupied, &truth);
  Fill(0, 1, kColumns, 60, CellState::kFree, &truth);
  TrinaryMap map = truth;
  map.at(30, 50) = CellState::kOccupied;
  const MapErrors errors = ErrorsOf(truth, map);
  EXPECT_NEAR(*errors.extra, 1.0 / 61.0, kNear);
  EXPECT_EQ(errors.outside, 0.0);
  EXPECT_NEAR(errors.map_to_truth_m->mean, kDistanceCap_m / 61.0, kNear) << "it is 2.45 m off";
}

TEST(MapError, OfUnknownSpaceIsItsPartOfTheSeenCells) {
  TrinaryMap map = Corridor();
  Fill(0, kBottomWall + 1, 15, kTopWall, CellState::kUnknown, &map);
  EXPECT_NEAR(*ErrorsOf(Corridor(), map).known, 0.75, kNear);
}

TEST(MapError, OfAThinWallSeenFromBothSidesIsNotBlur) {
  // A second corridor above the first, behind a wall of four cells with an opening on the right.
  TrinaryMap truth = UnknownMap(100, 60);
  Fill(0, 5, 100, 56, CellState::kOccupied, &truth);
  Fill(0, 6, 100, 20, CellState::kFree, &truth);
  Fill(0, 24, 100, 55, CellState::kFree, &truth);
  Fill(80, 20, 100, 24, CellState::kFree, &truth);
  TrinaryMap surfaces = truth;
  Fill(1, 21, 79, 23, CellState::kUnknown, &surfaces);
  backend::Trajectory poses;
  for (int i = 0; i < 18; ++i) {
    poses.push_back({0.0, {0.1 + 0.25 * i, 0.6, 0.0}});
    poses.push_back({0.0, {0.1 + 0.25 * i, 1.9, 0.0}});
  }
  const auto seen = LookAround(truth, poses, 30.0);
  const auto thin = SummarizeErrors(CompareMaps(truth, seen, surfaces, {}), 0.1);
  EXPECT_NEAR(thin.blur_m->p95, 0.05, kNear);
  // Filled, each side has half of the wall.
  const auto filled = SummarizeErrors(CompareMaps(truth, seen, truth, {}), 0.1);
  EXPECT_NEAR(filled.blur_m->p95, 0.1, kNear);
}

TEST(MapError, OfAPerfectMapperIsNoneInAnyGrid) {
  const TrinaryMap truth = Corridor();
  for (const double angle : {0.0, 0.3, std::numbers::pi / 2.0, -2.5}) {
    const backend::SE2 truth_T_map{1.234, -0.777, angle};
    TrinaryMap map = UnknownMap(200, 200);
    map.origin_x_m = map.origin_y_m = -5.0;
    const auto cell_at = [&](const Eigen::Vector2d& true_point) -> CellState& {
      const Eigen::Vector2d cell = ToCells(map, Inverse(truth_T_map) * true_point);
      return map.at(CellOf(cell.x()), CellOf(cell.y()));
    };
    for (int row = 3 * kBottomWall + 3; row < 3 * kTopWall; ++row) {
      for (int column = 0; column < 3 * kColumns; ++column) {
        cell_at(Eigen::Vector2d(column + 0.5, row + 0.5) * 0.05 / 3.0) = CellState::kFree;
      }
    }
    // Hits where the surface is: in the cells in front of it or behind it, as the grid falls.
    for (int i = 0; i < 3000; ++i) {
      cell_at({0.001 * (i + 0.5), 0.05 * (kBottomWall + 1)}) = CellState::kOccupied;
      cell_at({0.001 * (i + 0.5), 0.05 * kTopWall}) = CellState::kOccupied;
    }
    SCOPED_TRACE(angle);
    const MapErrors errors = ErrorsOf(truth, map, truth_T_map);
    ExpectPerfect(errors);
    EXPECT_GE(errors.blur_m->mean, 0.05 - kNear);
    EXPECT_LE(errors.blur_m->mean, 0.15) << "the stretch is not along the rows of the grid";
  }
}

TEST(MapError, OfAMapWithoutOccupiedCellsHasNoValueWhereThereIsNothingToMeasure) {
  const MapErrors errors = ErrorsOf(Corridor(), UnknownMap(5, 5));
  EXPECT_FALSE(errors.map_to_truth_m);
  EXPECT_FALSE(errors.precision);
  EXPECT_FALSE(errors.extra);
  EXPECT_FALSE(errors.blur_m);
  EXPECT_FALSE(errors.iou);
  EXPECT_EQ(errors.recall, 0.0);
  EXPECT_EQ(errors.missing, 1.0);
  EXPECT_EQ(errors.known, 0.0);
  EXPECT_NEAR(errors.truth_to_map_m->mean, kDistanceCap_m, kNear);
}

TEST(MapError, AMapIsBrokenWhenLessThanHalfOverlaps) {
  EXPECT_EQ(ErrorsOf(Corridor(), Corridor()).broken, false);
  EXPECT_EQ(ErrorsOf(Corridor(), Corridor(), {0.0, 0.1, 0.0}).broken, true) << "IoU is a third";
  EXPECT_EQ(ErrorsOf(Corridor(), UnknownMap(5, 5)).broken, true) << "nothing is drawn";
}

TEST(MapError, AllowsDifferentResolutions) {
  // The same corridor in cells of 0.1 m; the walls lie at multiples of that.
  TrinaryMap coarse = UnknownMap(kColumns / 2, 30);
  coarse.resolution_m = 0.1;
  Fill(0, 9, kColumns / 2, 21, CellState::kOccupied, &coarse);
  Fill(0, 10, kColumns / 2, 20, CellState::kFree, &coarse);
  const MapErrors of_coarse = ErrorsOf(Corridor(), coarse);
  ExpectPerfect(of_coarse);
  EXPECT_NEAR(of_coarse.blur_m->mean, 0.1, kNear);
  const MapErrors against_coarse = ErrorsOf(coarse, Corridor());
  ExpectPerfect(against_coarse);
  EXPECT_NEAR(against_coarse.blur_m->mean, 0.05, kNear);
}

}  // namespace
}  // namespace gmapping_spa::metrics::map_error_test
