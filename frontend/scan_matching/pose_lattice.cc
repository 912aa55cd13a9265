// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/pose_lattice.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace gmapping_spa::scan_matching {

using backend::SE2;
using map::CellIndex;

namespace {

// Cell of a coordinate that may be anywhere: beyond kMaxCellIndex there is no field.
int CellOf(double coordinate) {
  constexpr double kFar = map::kMaxCellIndex - 1;
  return map::FloorToCell(std::clamp(coordinate, -kFar, kFar));
}

}  // namespace

PoseLattice::PoseLattice(const Shape& shape, const FieldPyramid* pyramid,
                         const std::vector<Eigen::Vector2d>& points)
    : shape_(shape), pyramid_(pyramid), points_(points) {
  CHECK(shape.initial.IsFinite());
  CHECK_LT(points.size(), std::numeric_limits<int>::max() / 255u) << "sums of bytes overflow";
  cells_.resize(static_cast<std::size_t>(pyramid->levels()));
  for (std::size_t level = 0; level < cells_.size(); ++level) {
    cells_[level].resize(static_cast<std::size_t>(2 * shape.angular_steps >> level) + 1);
  }
}

const std::vector<CellIndex>& PoseLattice::Cells(int level, int group) const {
  std::vector<CellIndex>& cells =
      cells_[static_cast<std::size_t>(level)][static_cast<std::size_t>(group)];
  if (!cells.empty()) return cells;
  const double cells_per_m = 1.0 / shape_.linear_step_m;
  const double x0 = cells_per_m * shape_.initial.x, y0 = cells_per_m * shape_.initial.y;
  const int angles = 1 << level;
  const double middle = group * angles - shape_.angular_steps + 0.5 * (angles - 1);
  const double theta = shape_.initial.theta + middle * shape_.angular_step_rad;
  const double c = cells_per_m * std::cos(theta), s = cells_per_m * std::sin(theta);
  cells.reserve(points_.size());
  for (const Eigen::Vector2d& point : points_) {
    cells.push_back(
        {CellOf(x0 + c * point.x() - s * point.y()), CellOf(y0 + s * point.x() + c * point.y())});
  }
  return cells;
}

SE2 PoseLattice::Pose(const PoseBlock& pose) const {
  return {shape_.initial.x + pose.x * shape_.linear_step_m,
          shape_.initial.y + pose.y * shape_.linear_step_m,
          backend::WrapAngle(shape_.initial.theta + pose.angle * shape_.angular_step_rad)};
}

std::vector<PoseBlock> PoseLattice::Roots() const {
  // The parts of a root are the first to be bounded: its own level need not be in the pyramid.
  int level = 1;
  while (level < pyramid_->levels() && 1 << level < 2 * shape_.linear_steps + 1) ++level;
  const int size = 1 << level;
  std::vector<PoseBlock> roots;
  for (int angle = -shape_.angular_steps; angle <= shape_.angular_steps; angle += size) {
    for (int y = -shape_.linear_steps; y <= shape_.linear_steps; y += size) {
      for (int x = -shape_.linear_steps; x <= shape_.linear_steps; x += size) {
        roots.push_back({.level = level, .angle = angle, .x = x, .y = y});
      }
    }
  }
  return roots;
}

Eigen::Array4i PoseLattice::Bounds(const PoseBlock& first) const {
  const ByteGrid& level = pyramid_->level(first.level);
  const int size = 1 << first.level;
  const int group = (first.angle + shape_.angular_steps) >> first.level;
  int sum_00 = 0, sum_10 = 0, sum_01 = 0, sum_11 = 0;
  for (const CellIndex& cell : Cells(first.level, group)) {
    const int x = cell.x + first.x, y = cell.y + first.y;
    const unsigned left = level.Column(x), right = level.Column(x + size);
    const std::uint8_t* low = level.RowValues(level.Row(y));
    const std::uint8_t* high = level.RowValues(level.Row(y + size));
    sum_00 += low[left];
    sum_10 += low[right];
    sum_01 += high[left];
    sum_11 += high[right];
  }
  return {sum_00, sum_10, sum_01, sum_11};
}

}  // namespace gmapping_spa::scan_matching
