// Maps of synthetic rooms, as a robot would have made them at poses that are known exactly.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_ROOM_MAP_H_
#define GMAPPING_SPA_TESTS_FRONTEND_ROOM_MAP_H_

#include <cmath>
#include <vector>

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/map/scan_registration.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::synthetic {

inline map::OccupancyGrid MapFrom(const Walls& walls,
                                  const std::vector<backend::SE2>& world_T_robots,
                                  const Laser& laser = {}) {
  map::OccupancyGrid grid({});
  for (const backend::SE2& world_T_robot : world_T_robots) {
    map::RegisterScan(Scan(walls, world_T_robot, laser), world_T_robot, {}, &grid);
  }
  return grid;
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
