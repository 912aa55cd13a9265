// SPDX-License-Identifier: BSD-3-Clause
// Solid shapes in the world frame, in metres.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_SHAPES_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_SHAPES_H_

#include <Eigen/Core>
#include <optional>

#include "backend/se2.h"

namespace gmapping_spa::simulation {

struct Rectangle {
  backend::SE2 world_T_center;  // the sides are along its axes
  Eigen::Vector2d half_size_m;

  // With sides along the axes of the world.
  static Rectangle FromCorners(const Eigen::Vector2d& min, const Eigen::Vector2d& max);

  // Half the extents of the smallest rectangle of that kind that holds this one.
  Eigen::Vector2d HalfExtent() const;
  Eigen::Vector2d center() const { return world_T_center.translation(); }
  bool Contains(const Eigen::Vector2d& world_point) const;
  // The point of the rectangle that is nearest to another point.
  Eigen::Vector2d Nearest(const Eigen::Vector2d& world_point) const;
  // Distance along the ray to where it enters; 0 from inside, nothing when it misses.
  std::optional<double> CastRay(const Eigen::Vector2d& world_origin, double world_angle_rad) const;
};

struct Disc {
  Eigen::Vector2d world_center;
  double radius_m = 0.0;

  Eigen::Vector2d HalfExtent() const { return {radius_m, radius_m}; }
  Eigen::Vector2d center() const { return world_center; }
  bool Contains(const Eigen::Vector2d& world_point) const {
    return (world_point - world_center).norm() <= radius_m;
  }
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_SHAPES_H_
