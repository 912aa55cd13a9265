// SPDX-License-Identifier: BSD-3-Clause
// Worlds made of straight walls, in which the range of every beam is known exactly.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_SYNTHETIC_ROOM_H_
#define GMAPPING_SPA_TESTS_FRONTEND_SYNTHETIC_ROOM_H_

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "backend/se2.h"
#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::synthetic {

struct Wall {
  Eigen::Vector2d from, to;
};
using Walls = std::vector<Wall>;

// Adds the closed polygon through `corners`, rotated about the origin.
inline void AddPolygon(const std::vector<Eigen::Vector2d>& corners, double rotation_rad,
                       Walls* walls) {
  const backend::SE2 rotation{0, 0, rotation_rad};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    walls->push_back({rotation * corners[i], rotation * corners[(i + 1) % corners.size()]});
  }
}

// About 9 m x 7 m around the origin, with a niche and a box in it; no wall is parallel to an axis.
inline Walls Room() {
  Walls walls;
  AddPolygon({{-4, -3}, {5, -3.4}, {5, 1}, {3, 1}, {3, 3.5}, {-4, 3.7}}, 0.3, &walls);
  AddPolygon({{-2.5, 1.2}, {-1.7, 1.2}, {-1.7, 2.0}, {-2.5, 2.0}}, 0.7, &walls);
  return walls;
}

// Two parallel walls 2 m apart and far too long for a laser to see an end.
inline Walls Corridor(double direction_rad) {
  Walls walls;
  const backend::SE2 rotation{0, 0, direction_rad};
  for (const double y : {-1.0, 1.0}) {
    walls.push_back({rotation * Eigen::Vector2d(-200, y), rotation * Eigen::Vector2d(200, y)});
  }
  return walls;
}

// Distance from `pose` to the first wall along its x axis, or infinity.
inline double Range(const Walls& walls, const backend::SE2& pose) {
  const Eigen::Vector2d direction(std::cos(pose.theta), std::sin(pose.theta));
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const Eigen::Vector2d along = wall.to - wall.from, to_wall = wall.from - pose.translation();
    const double denominator = cross(direction, along);
    if (denominator == 0.0) continue;
    const double range_m = cross(to_wall, along) / denominator;
    const double part_of_wall = cross(to_wall, direction) / denominator;
    if (range_m > 0.0 && range_m < nearest_m && part_of_wall >= 0.0 && part_of_wall <= 1.0) {
      nearest_m = range_m;
    }
  }
  return nearest_m;
}

struct Laser {
  int beams = 181;
  double field_of_view_rad = std::numbers::pi;
  double usable_range_m = 20.0;
  backend::SE2 robot_T_laser = {};
};

// What a perfect laser measures on a robot at `world_T_robot`, whose odometry is perfect as well.
inline sensor::LaserScan Scan(const Walls& walls, const backend::SE2& world_T_robot,
                              const Laser& laser = {}) {
  sensor::LaserScan scan;
  scan.odom_T_robot = world_T_robot;
  scan.robot_T_laser = laser.robot_T_laser;
  const backend::SE2 world_T_laser = world_T_robot * laser.robot_T_laser;
  for (int i = 0; i < laser.beams; ++i) {
    const double angle_rad = laser.field_of_view_rad * (i / (laser.beams - 1.0) - 0.5);
    const double range_m = Range(walls, world_T_laser * backend::SE2{0, 0, angle_rad});
    if (range_m < laser.usable_range_m) {
      scan.beams.push_back({angle_rad, range_m, sensor::BeamStatus::kHit});
    } else {
      scan.beams.push_back({angle_rad, laser.usable_range_m, sensor::BeamStatus::kNoReturn});
    }
  }
  return scan;
}

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_SYNTHETIC_ROOM_H_
