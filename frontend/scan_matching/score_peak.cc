// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/score_peak.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gmapping_spa::scan_matching {

using backend::SE2;

// Poses with less weight than this are left out of the moments, which saves most of the peak.
constexpr double kNegligibleWeight = 0.01;

ScorePeak::ScorePeak(const PoseLattice* lattice, const PoseBlock& best, double separation_m,
                     double separation_rad)
    : lattice_(lattice),
      best_(best),
      squared_radius_(std::pow(separation_m / lattice->shape().linear_step_m, 2)),
      separation_rad_(separation_rad) {}

bool ScorePeak::HoldsAllOf(const PoseBlock& block) const {
  return HoldsOffset(
      block, [](double first, double last) { return std::max(std::abs(first), std::abs(last)); });
}

bool ScorePeak::HoldsSomeOf(const PoseBlock& block) const {
  return HoldsOffset(block, [](double first, double last) { return std::clamp(0.0, first, last); });
}

template <typename Choose>
bool ScorePeak::HoldsOffset(const PoseBlock& block, const Choose& choose) const {
  const double last = (1 << block.level) - 1;
  const double x = block.x - best_.x, y = block.y - best_.y;
  const double dx = choose(x, x + last), dy = choose(y, y + last);
  if (dx * dx + dy * dy > squared_radius_) return false;
  const double step_rad = lattice_->shape().angular_step_rad;
  const double angle_rad = backend::WrapAngle((block.angle - best_.angle) * step_rad);
  return std::abs(choose(angle_rad, angle_rad + last * step_rad)) <= separation_rad_;
}

Eigen::Matrix3d ScorePeak::Covariance(double log_weight_per_sum) const {
  const double floor = best_.bound + std::log(kNegligibleWeight) / log_weight_per_sum;
  const SE2 mode = lattice_->Pose(best_);
  double weights = 0.0;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  std::vector<PoseBlock> blocks = lattice_->Roots();
  while (!blocks.empty()) {
    const PoseBlock block = blocks.back();
    blocks.pop_back();
    if (block.bound < floor || !HoldsSomeOf(block)) continue;
    if (block.level > 0) {
      lattice_->ForEachPart(block, [&](const PoseBlock& part) { blocks.push_back(part); });
      continue;
    }
    const Eigen::Vector3d offset = Minus(lattice_->Pose(block), mode);
    const double weight = std::exp(log_weight_per_sum * (block.bound - best_.bound));
    weights += weight;
    moments += weight * offset * offset.transpose();
  }
  const PoseLattice::Shape& shape = lattice_->shape();
  const Eigen::Array3d steps(shape.linear_step_m, shape.linear_step_m, shape.angular_step_rad);
  Eigen::Matrix3d covariance = moments / weights;
  covariance.diagonal() += (steps.square() / 12.0).matrix();
  return covariance;
}

}  // namespace gmapping_spa::scan_matching
