// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/seen_space.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
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

Lookout::Lookout(const map::TrinaryMap* truth, double max_range_m)
    : truth_(truth), max_range_m_(max_range_m), seen_{truth->width, truth->height, {}, {}, 0} {
  seen_.sides.assign(truth->cells.size(), 0);
  seen_.seen.assign(truth->cells.size(), 0);
  for (int i = 0; i < kDirections; ++i) {
    const double angle = (i + 0.5) * 2.0 * std::numbers::pi / kDirections;
    directions_.emplace_back(std::cos(angle), std::sin(angle));
  }
}

void Lookout::Look(const backend::SE2& truth_T_robot) {
  const map::TrinaryMap& truth = *truth_;
  const Eigen::Vector2d position = truth_T_robot.translation();
  if (last_view_point_ && (position - *last_view_point_).norm() < kViewPointDistance_m) return;
  const Eigen::Vector2d origin = ToCells(truth, position);
  if (StateAt(truth, CellOf(origin.x()), CellOf(origin.y())) != CellState::kFree) return;
  last_view_point_ = position;
  ++seen_.view_points;
  int from_column = 0, from_row = 0;
  const auto look = [&](int column, int row, double, double) {
    const CellState state = StateAt(truth, column, row);
    if (state == CellState::kFree) {
      seen_.seen[static_cast<std::size_t>(row) * truth.width + column] = 1;
      from_column = column;
      from_row = row;
    } else if (state == CellState::kOccupied) {
      seen_.sides[static_cast<std::size_t>(row) * truth.width + column] |=
          SideBit(from_column - column, from_row - row);
    }
    return state == CellState::kFree;
  };
  for (const Eigen::Vector2d& direction : directions_) {
    VisitCellsAlong(origin, direction, max_range_m_ / truth.resolution_m, look);
  }
}

SeenSpace LookAround(const map::TrinaryMap& truth, const backend::Trajectory& true_poses,
                     double max_range_m) {
  Lookout lookout(&truth, max_range_m);
  for (const auto& [stamp_s, pose] : true_poses) lookout.Look(pose);
  if (lookout.seen().view_points == 0) {
    throw std::runtime_error(
        "expected true poses in the free space of the true map, found none there");
  }
  return lookout.seen();
}

}  // namespace gmapping_spa::metrics
