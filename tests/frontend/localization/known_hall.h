// SPDX-License-Identifier: BSD-3-Clause
// A hall that was mapped, and robots that drive in it without knowing where they are.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_LOCALIZATION_KNOWN_HALL_H_
#define GMAPPING_SPA_TESTS_FRONTEND_LOCALIZATION_KNOWN_HALL_H_

#include <vector>

#include "frontend/map/occupancy_grid.h"
#include "frontend/map/scan_insertion.h"
#include "tests/frontend/loop_closure/hall.h"
#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::synthetic {

inline const Laser kHallLaser{.beams = 181, .field_of_view_rad = 3.2, .usable_range_m = 10.0};

// In the frame of the walls.
inline map::OccupancyGrid MapOf(const Walls& walls, double from_m = 0.0, double to_m = 48.0) {
  map::OccupancyGrid map({});
  for (const backend::SE2& pose : DriveOnRing(from_m, to_m, 0.2)) {
    map::InsertScan(Scan(walls, pose, kHallLaser), pose, {}, &map);
  }
  return map;
}

// Scans on a drive, with their true poses as odometry.
inline std::vector<sensor::LaserScan> Driven(const Walls& walls, double from_m, double to_m,
                                             double step_m = 0.1) {
  return ScansAt(DriveOnRing(from_m, to_m, step_m), walls, kHallLaser);
}

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_LOCALIZATION_KNOWN_HALL_H_
