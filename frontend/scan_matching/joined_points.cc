// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/joined_points.h"

#include <cmath>

namespace gmapping_spa::scan_matching {

using backend::SE2;

void JoinedPoints::Add(const ScanPoints& points, const SE2& reference_T_scan) {
  const SE2 rotation{0, 0, reference_T_scan.theta};
  for (const ScanPoint& point : points) {
    const Eigen::Vector2d at = reference_T_scan * Eigen::Vector2d(point.x_m, point.y_m);
    const auto column = static_cast<std::int64_t>(std::floor(at.x() / cell_m_));
    const auto row = static_cast<std::int64_t>(std::floor(at.y() / cell_m_));
    if (!taken_.insert(column * (std::int64_t{1} << 32) + row).second) continue;
    const Eigen::Vector2d back = rotation * Eigen::Vector2d(point.back_x, point.back_y);
    points_.push_back({at.x(), at.y(), back.x(), back.y()});
  }
}

std::vector<Eigen::Vector2d> PositionsOf(const ScanPoints& points) {
  std::vector<Eigen::Vector2d> positions;
  positions.reserve(points.size());
  for (const ScanPoint& point : points) positions.emplace_back(point.x_m, point.y_m);
  return positions;
}

std::vector<Eigen::Vector2d> Thinned(const std::vector<Eigen::Vector2d>& positions, int count) {
  const std::size_t stride = positions.size() / static_cast<std::size_t>(count) + 1;
  std::vector<Eigen::Vector2d> thinned;
  for (std::size_t k = 0; k < positions.size(); k += stride) thinned.push_back(positions[k]);
  return thinned;
}

}  // namespace gmapping_spa::scan_matching
