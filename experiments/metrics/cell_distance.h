// SPDX-License-Identifier: BSD-3-Clause
// Distances between the cells of a map, as squares, and points or edges.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_CELL_DISTANCE_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_CELL_DISTANCE_H_

#include <Eigen/Core>
#include <algorithm>

namespace gmapping_spa::metrics {

// An axis-parallel square, and a line from one point to another.
struct Square {
  Eigen::Vector2d center;
  double half_side;
};
struct Segment {
  Eigen::Vector2d from, to;
};

// 0 inside and on the edge.
inline double Distance(const Square& square, const Eigen::Vector2d& point) {
  return ((point - square.center).array().abs() - square.half_side).max(0.0).matrix().norm();
}

inline double Distance(const Segment& segment, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = segment.to - segment.from;
  const double share =
      std::clamp((point - segment.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (segment.from + share * along - point).norm();
}

inline bool Intersect(const Square& square, const Segment& segment) {
  const Eigen::Vector2d from = segment.from - square.center, along = segment.to - segment.from;
  double enter = 0.0, leave = 1.0;  // shares of the segment
  for (const int axis : {0, 1}) {
    if (along[axis] == 0.0) {
      if (std::abs(from[axis]) > square.half_side) return false;
      continue;
    }
    const double low = (-square.half_side - from[axis]) / along[axis];
    const double high = (square.half_side - from[axis]) / along[axis];
    enter = std::max(enter, std::min(low, high));
    leave = std::min(leave, std::max(low, high));
  }
  return enter <= leave;
}

inline double Distance(const Square& square, const Segment& segment) {
  if (Intersect(square, segment)) return 0.0;
  double distance = std::min(Distance(square, segment.from), Distance(square, segment.to));
  for (const double x : {-square.half_side, square.half_side}) {
    for (const double y : {-square.half_side, square.half_side}) {
      distance = std::min(distance, Distance(segment, square.center + Eigen::Vector2d(x, y)));
    }
  }
  return distance;
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_CELL_DISTANCE_H_
