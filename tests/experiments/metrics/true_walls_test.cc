// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/true_walls.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/metrics/hand_made_building.h"

namespace gmapping_spa::metrics {
namespace {

std::vector<Stretch> Walls(const MapComparison& comparison) {
  return JoinElements(comparison.surface, comparison.truth_resolution_m,
                      [](std::size_t) { return true; });
}

TEST(TrueWalls, EndAtCornersAndDoors) {
  const MapComparison comparison = CompareWithBuilding(Building());
  int long_ones = 0;
  for (const Stretch& wall : Walls(comparison)) {
    const Eigen::Vector2d& normal = comparison.surface[wall[0]].across->normal;
    for (const std::size_t i : wall) {
      EXPECT_GT(comparison.surface[i].across->normal.dot(normal), 0.99);
      EXPECT_NEAR(
          (comparison.surface[i].middle() - comparison.surface[wall[0]].middle()).dot(normal), 0.0,
          1e-9);
    }
    long_ones += Length_m(comparison.surface, wall) > kMinWall_m;
  }
  EXPECT_EQ(long_ones, 14) << "six of the rooms, four of the inner wall, four of the pillar";
}

TEST(TrueWalls, GoOnPastElementsThatDoNotCount) {
  const MapComparison comparison = CompareWithBuilding(Building());
  const auto& surface = comparison.surface;
  const auto pieces = [&](double hole_m) {
    const auto counts = [&](std::size_t i) {
      const Eigen::Vector2d middle = surface[i].middle();
      return middle.x() < 1.001 && std::abs(middle.y() - 4.0) > 0.5 * hole_m;
    };
    int number = 0;
    for (const Stretch& piece : JoinElements(surface, 0.05, counts)) number += piece.size() > 6;
    return number;
  };
  EXPECT_EQ(pieces(0.1), 1);
  EXPECT_EQ(pieces(0.3), 2);
}

TEST(TrueWalls, MayBeSlanted) {
  map::TrinaryMap truth = UnknownMap(100, 100);
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 100; ++column) {
      truth.at(column, row) =
          column + 2 * row < 100 ? map::CellState::kOccupied : map::CellState::kFree;
    }
  }
  const backend::Trajectory poses = {{0.0, {3.0, 3.0, 0.0}}, {1.0, {1.0, 4.0, 0.0}}};
  const auto comparison = CompareMaps(truth, LookAround(truth, poses, 30.0), truth, {});
  double length_m = 0.0;
  for (const Stretch& wall : Walls(comparison)) {
    length_m = std::max(length_m, Length_m(comparison.surface, wall));
  }
  EXPECT_NEAR(length_m, std::hypot(5.0, 2.5), 0.8) << "ends are not in sight";
}

}  // namespace
}  // namespace gmapping_spa::metrics
