// SPDX-License-Identifier: BSD-3-Clause
// Maps of synthetic rooms, as a robot would have made them at poses that are known exactly.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_ROOM_MAP_H_
#define GMAPPING_SPA_TESTS_FRONTEND_ROOM_MAP_H_

#include <cmath>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/map/scan_insertion.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::synthetic {

inline map::OccupancyGrid MapFrom(const Walls& walls,
                                  const std::vector<backend::SE2>& world_T_robots,
                                  const Laser& laser = {}) {
  map::OccupancyGrid grid({});
  for (const backend::SE2& world_T_robot : world_T_robots) {
    map::InsertScan(Scan(walls, world_T_robot, laser), world_T_robot, {}, &grid);
  }
  return grid;
}

// Part of the beams of `scan`, taken at `world_T_robot`, that fit `grid`: they end within a cell of
// one in which beams have ended, and meet none of these half way. Needs at least one beam that
// hits.
inline double FittingPart(const map::OccupancyGrid& grid, const sensor::LaserScan& scan,
                          const backend::SE2& world_T_robot) {
  const backend::SE2 world_T_laser = world_T_robot * scan.robot_T_laser;
  const auto hit_near = [&](const sensor::Beam& beam, double range_m, int cells) {
    const Eigen::Vector2d point =
        world_T_laser *
        Eigen::Vector2d(range_m * std::cos(beam.angle_rad), range_m * std::sin(beam.angle_rad));
    const int x = map::FloorToCell(point.x() / grid.resolution_m());
    const int y = map::FloorToCell(point.y() / grid.resolution_m());
    for (int dy = -cells; dy <= cells; ++dy) {
      for (int dx = -cells; dx <= cells; ++dx) {
        if (grid.cell({x + dx, y + dy}).hits > 0) return true;
      }
    }
    return false;
  };
  int hits = 0, fitting = 0;
  for (const sensor::Beam& beam : scan.beams) {
    if (beam.status != sensor::BeamStatus::kHit) continue;
    ++hits;
    fitting += hit_near(beam, beam.range_m, 1) && !hit_near(beam, 0.5 * beam.range_m, 0);
  }
  return static_cast<double>(fitting) / hits;
}

// Of Room(): from a dozen places in it, three ways each.
inline map::OccupancyGrid RoomMap() {
  std::vector<backend::SE2> poses;
  for (int i = 0; i < 36; ++i) {
    const double around = 0.55 * i;
    poses.push_back({1.3 * std::cos(around), 1.1 * std::sin(around), 2.1 * i});
  }
  return MapFrom(Room(), poses);
}

// Of Corridor(direction_rad): from its middle, up and down.
inline map::OccupancyGrid CorridorMap(double direction_rad, const Laser& laser = {}) {
  std::vector<backend::SE2> poses;
  for (int i = -40; i <= 40; ++i) {
    const double along_m = 0.31 * i;
    poses.push_back({along_m * std::cos(direction_rad), along_m * std::sin(direction_rad),
                     direction_rad + (i % 2 == 0 ? 0.0 : 3.0)});
  }
  return MapFrom(Corridor(direction_rad), poses, laser);
}

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_ROOM_MAP_H_
