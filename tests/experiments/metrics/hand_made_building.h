// SPDX-License-Identifier: BSD-3-Clause
// Two rooms with a door and a pillar, and ways to draw them wrongly.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_METRICS_HAND_MADE_BUILDING_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_METRICS_HAND_MADE_BUILDING_H_

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "experiments/metrics/map_comparison.h"
#include "tests/experiments/metrics/hand_made_map.h"

namespace gmapping_spa::metrics {

// Metres: x from left to right, y from bottom to top.
struct Box {
  double left, bottom, right, top;
  bool Contains(const Eigen::Vector2d& point) const {
    return point.x() > left && point.x() < right && point.y() > bottom && point.y() < top;
  }
};

// Rooms of 3.8 m x 6 m and 4 m x 6 m, between them a wall of 0.2 m with a door of 1 m.
inline const Box kInside{1.0, 1.0, 9.0, 7.0}, kWallBelowDoor{4.8, 1.0, 5.0, 4.6},
    kWallAboveDoor{4.8, 5.6, 5.0, 7.0}, kPillar{6.8, 3.8, 7.4, 4.4};

// As simulate writes the truth: cells of solids that touch free ones are occupied.
inline map::TrinaryMap Building(double resolution_m = 0.05, bool with_pillar = true) {
  const int width = static_cast<int>(std::lround(10.0 / resolution_m));
  const int height = static_cast<int>(std::lround(8.0 / resolution_m));
  map::TrinaryMap map = UnknownMap(width, height);
  map.resolution_m = resolution_m;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Eigen::Vector2d point = CellCenter(map, column, row);
      const bool solid = kWallBelowDoor.Contains(point) || kWallAboveDoor.Contains(point) ||
                         (with_pillar && kPillar.Contains(point));
      if (kInside.Contains(point) && !solid) map.at(column, row) = map::CellState::kFree;
    }
  }
  map::TrinaryMap shells = map;
  for (int row = 1; row + 1 < height; ++row) {
    for (int column = 1; column + 1 < width; ++column) {
      if (map.at(column, row) == map::CellState::kFree) continue;
      for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
          if (map.at(x, y) == map::CellState::kFree) {
            shells.at(column, row) = map::CellState::kOccupied;
          }
        }
      }
    }
  }
  return shells;
}

// Occupied cells in the box become free.
inline map::TrinaryMap Without(map::TrinaryMap map, const Box& box) {
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      map::CellState& state = map.at(column, row);
      if (state == map::CellState::kOccupied && box.Contains(CellCenter(map, column, row))) {
        state = map::CellState::kFree;
      }
    }
  }
  return map;
}

// What is occupied in the box is drawn a second time, farther right and up.
inline map::TrinaryMap DrawnTwice(const map::TrinaryMap& map, const Box& box, double right_m,
                                  double up_m) {
  map::TrinaryMap twice = map;
  const int right = static_cast<int>(std::lround(right_m / map.resolution_m));
  const int up = static_cast<int>(std::lround(up_m / map.resolution_m));
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) == map::CellState::kOccupied &&
          box.Contains(CellCenter(map, column, row))) {
        twice.at(column + right, row + up) = map::CellState::kOccupied;
      }
    }
  }
  return twice;
}

// Seen from a tour of both rooms, round the pillar.
inline MapComparison CompareWithBuilding(const map::TrinaryMap& map,
                                         const map::TrinaryMap& truth = Building(),
                                         const backend::SE2& truth_T_map = {}) {
  const std::vector<Eigen::Vector2d> tour = {{2.0, 2.0}, {2.0, 6.0}, {4.0, 5.1}, {6.0, 5.1},
                                             {8.2, 5.5}, {8.2, 2.5}, {6.0, 2.5}, {6.0, 5.1}};
  backend::Trajectory poses;
  for (std::size_t i = 0; i + 1 < tour.size(); ++i) {
    for (const double share : {0.0, 0.25, 0.5, 0.75}) {
      const Eigen::Vector2d point = tour[i] + share * (tour[i + 1] - tour[i]);
      poses.push_back({0.0, {point.x(), point.y(), 0.0}});
    }
  }
  return CompareMaps(truth, LookAround(truth, poses, 30.0), map, truth_T_map);
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_METRICS_HAND_MADE_BUILDING_H_
