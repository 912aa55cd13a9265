// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/pedestrian.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace gmapping_spa::simulation {

Rectangle Pedestrian::At(double time_s) const {
  double length_m = 0.0;
  for (std::size_t i = 1; i < way_points.size(); ++i) {
    length_m += (way_points[i] - way_points[i - 1]).norm();
  }
  const double walked_m = std::fmod(speed_m_s * time_s, 2.0 * length_m);
  const bool back = walked_m > length_m;
  double left_m = back ? 2.0 * length_m - walked_m : walked_m;  // from the first way point
  std::size_t leg = 1;
  while (leg + 1 < way_points.size() && left_m > (way_points[leg] - way_points[leg - 1]).norm()) {
    left_m -= (way_points[leg] - way_points[leg - 1]).norm();
    ++leg;
  }
  const Eigen::Vector2d along = (way_points[leg] - way_points[leg - 1]).normalized();
  const Eigen::Vector2d position = way_points[leg - 1] + left_m * along;
  const double heading_rad = std::atan2(along.y(), along.x()) + (back ? std::numbers::pi : 0.0);
  return {{position.x(), position.y(), backend::WrapAngle(heading_rad)}, size_m / 2.0};
}

}  // namespace gmapping_spa::simulation
