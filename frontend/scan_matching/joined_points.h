// SPDX-License-Identifier: BSD-3-Clause
// The end points of many scans as one.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_MATCHING_JOINED_POINTS_H_
#define GMAPPING_SPA_FRONTEND_SCAN_MATCHING_JOINED_POINTS_H_

#include <Eigen/Core>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "backend/se2.h"
#include "frontend/scan_matching/scan_points.h"

namespace gmapping_spa::scan_matching {

// At most one end point in each cell of a grid, the first one.
class JoinedPoints {
 public:
  explicit JoinedPoints(double cell_m) : cell_m_(cell_m) {}

  void Add(const ScanPoints& points, const backend::SE2& reference_T_scan);

  // In the frame of reference, with the directions toward the laser.
  const ScanPoints& points() const { return points_; }

 private:
  double cell_m_;
  ScanPoints points_;
  std::unordered_set<std::int64_t> taken_;
};

// Where they are.
std::vector<Eigen::Vector2d> PositionsOf(const ScanPoints& points);

// At most so many, spread evenly.
std::vector<Eigen::Vector2d> Thinned(const std::vector<Eigen::Vector2d>& positions, int count);

}  // namespace gmapping_spa::scan_matching

#endif  // GMAPPING_SPA_FRONTEND_SCAN_MATCHING_JOINED_POINTS_H_
