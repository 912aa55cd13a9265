// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/grid_ray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace gmapping_spa::metrics {
namespace {

using ::testing::ElementsAre;

std::vector<std::array<int, 2>> CellsAlong(const Eigen::Vector2d& origin,
                                           const Eigen::Vector2d& direction, double length) {
  std::vector<std::array<int, 2>> cells;
  VisitCellsAlong(origin, direction.normalized(), length, [&](int column, int row, double, double) {
    cells.push_back({column, row});
    return true;
  });
  return cells;
}

TEST(GridRay, VisitsTheCellsInOrder) {
  EXPECT_THAT(CellsAlong({0.5, 0.5}, {1.0, 0.0}, 2.0),
              ElementsAre(std::array{0, 0}, std::array{1, 0}, std::array{2, 0}));
  EXPECT_THAT(CellsAlong({0.5, 0.5}, {0.0, -1.0}, 2.0),
              ElementsAre(std::array{0, 0}, std::array{0, -1}, std::array{0, -2}));
  EXPECT_THAT(CellsAlong({0.5, 0.5}, {2.0, 1.0}, 2.0),
              ElementsAre(std::array{0, 0}, std::array{1, 0}, std::array{1, 1}, std::array{2, 1}));
}

TEST(GridRay, TellsWhereItEntersAndLeavesEachCell) {
  std::vector<double> ends;
  double last_end = 0.0;
  VisitCellsAlong({0.25, 0.5}, {1.0, 0.0}, 2.0, [&](int, int, double begin, double end) {
    EXPECT_EQ(begin, last_end);
    last_end = end;
    ends.push_back(end);
    return true;
  });
  EXPECT_THAT(ends, ElementsAre(0.75, 1.75, 2.0));
}

TEST(GridRay, StopsWhenToldTo) {
  int visits = 0;
  VisitCellsAlong({0.5, 0.5}, {1.0, 0.0}, 100.0, [&](int column, int, double, double) {
    ++visits;
    return column < 3;
  });
  EXPECT_EQ(visits, 4);
}

TEST(GridRay, HasItsWholeLengthInTheCells) {
  for (int i = 0; i < 64; ++i) {
    const double angle = 0.1 * i;
    double length = 0.0;
    VisitCellsAlong({-3.3, 7.0}, {std::cos(angle), std::sin(angle)}, 25.0,
                    [&](int column, int row, double begin, double end) {
                      const Eigen::Vector2d middle =
                          Eigen::Vector2d(-3.3, 7.0) +
                          0.5 * (begin + end) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
                      EXPECT_LE(
                          (middle - Eigen::Vector2d(column + 0.5, row + 0.5)).cwiseAbs().maxCoeff(),
                          0.5 + 1e-9);
                      length += end - begin;
                      return true;
                    });
    EXPECT_NEAR(length, 25.0, 1e-9);
  }
}

}  // namespace
}  // namespace gmapping_spa::metrics
