// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gmapping_spa::simulation {

Rectangle Rectangle::FromCorners(const Eigen::Vector2d& min, const Eigen::Vector2d& max) {
  const Eigen::Vector2d center = (min + max) / 2.0;
  return {{center.x(), center.y(), 0.0}, (max - min) / 2.0};
}

Eigen::Vector2d Rectangle::HalfExtent() const {
  const double c = std::abs(std::cos(world_T_center.theta));
  const double s = std::abs(std::sin(world_T_center.theta));
  return {c * half_size_m.x() + s * half_size_m.y(), s * half_size_m.x() + c * half_size_m.y()};
}

bool Rectangle::Contains(const Eigen::Vector2d& world_point) const {
  const Eigen::Vector2d point = Inverse(world_T_center) * world_point;
  return (point.array().abs() <= half_size_m.array()).all();
}

Eigen::Vector2d Rectangle::Nearest(const Eigen::Vector2d& world_point) const {
  const Eigen::Vector2d point = Inverse(world_T_center) * world_point;
  const Eigen::Vector2d nearest = point.cwiseMax(-half_size_m).cwiseMin(half_size_m);
  return world_T_center * nearest;
}

// Between the two lines of each pair of sides: the slab method.
std::optional<double> Rectangle::CastRay(const Eigen::Vector2d& world_origin,
                                         double world_angle_rad) const {
  const Eigen::Vector2d origin = Inverse(world_T_center) * world_origin;
  const double angle_rad = world_angle_rad - world_T_center.theta;
  const Eigen::Vector2d direction(std::cos(angle_rad), std::sin(angle_rad));
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  for (const int axis : {0, 1}) {
    if (direction[axis] == 0.0) {
      if (std::abs(origin[axis]) > half_size_m[axis]) return std::nullopt;
      continue;
    }
    double near = (-half_size_m[axis] - origin[axis]) / direction[axis];
    double far = (half_size_m[axis] - origin[axis]) / direction[axis];
    if (near > far) std::swap(near, far);
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  if (enter > leave) return std::nullopt;
  return enter;
}

}  // namespace gmapping_spa::simulation
