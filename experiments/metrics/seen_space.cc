// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/seen_space.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "experiments/metrics/grid_ray.h"
#include "experiments/metrics/map_cells.h"

namespace gmapping_spa::metrics {
namespace {

using map::CellState;

constexpr double kViewPointDistance_m = 0.25;
constexpr int kDirections = 1440;

// The bit of the side with the neighbor at this step.
std::uint8_t SideBit(int step_x, int step_y) {
  const auto side = std::find(kSides.begin(), kSides.end(), std::array{step_x, step_y});
  return static_cast<std::uint8_t>(1 << (side - kSides.begin()));
}

}  // namespace

SeenSpace LookAround(const map::TrinaryMap& truth, const backend::Trajectory& true_poses,
                     double max_range_m) {
  SeenSpace space{truth.width, truth.height, {}, {}, 0};
  space.sides.assign(truth.cells.size(), 0);
  space.seen.assign(truth.cells.size(), 0);
  std::vector<Eigen::Vector2d> directions;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = (i + 0.5) * 2.0 * std::numbers::pi / kDirections;
    directions.emplace_back(std::cos(angle), std::sin(angle));
  }
  int from_column = 0, from_row = 0;
  const auto look = [&](int column, int row, double, double) {
    const CellState state = StateAt(truth, column, row);
    if (state == CellState::kFree) {
      space.seen[static_cast<std::size_t>(row) * truth.width + column] = 1;
      from_column = column;
      from_row = row;
    } else if (state == CellState::kOccupied) {
      space.sides[static_cast<std::size_t>(row) * truth.width + column] |=
          SideBit(from_column - column, from_row - row);
    }
    return state == CellState::kFree;
  };
  std::optional<Eigen::Vector2d> last_view_point;
  for (const auto& [stamp_s, pose] : true_poses) {
    const Eigen::Vector2d position = pose.translation();
    if (last_view_point && (position - *last_view_point).norm() < kViewPointDistance_m) continue;
    const Eigen::Vector2d origin = ToCells(truth, position);
    if (StateAt(truth, CellOf(origin.x()), CellOf(origin.y())) != CellState::kFree) continue;
    last_view_point = position;
    ++space.view_points;
    for (const Eigen::Vector2d& direction : directions) {
      VisitCellsAlong(origin, direction, max_range_m / truth.resolution_m, look);
    }
  }
  if (space.view_points == 0) {
    throw std::runtime_error(
        "expected true poses in the free space of the true map, found none there");
  }
  return space;
}

}  // namespace gmapping_spa::metrics
