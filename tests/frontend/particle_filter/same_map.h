// SPDX-License-Identifier: BSD-3-Clause
// Maps that must be the same to the bit, and those that trajectories must lead to.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_SAME_MAP_H_
#define GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_SAME_MAP_H_

#include <vector>

#include "frontend/map/occupancy_grid.h"
#include "frontend/map/scan_insertion.h"
#include "frontend/particle_filter/trajectory_tree.h"

namespace gmapping_spa::particle_filter {

inline bool SameMap(const map::OccupancyGrid& a, const map::OccupancyGrid& b) {
  const map::OccupancyGrid::Extent extent = a.KnownExtent();
  if (!(extent.min == b.KnownExtent().min && extent.max == b.KnownExtent().max)) return false;
  for (int y = extent.min.y; y < extent.max.y; ++y) {
    for (int x = extent.min.x; x < extent.max.x; ++x) {
      const map::Cell &u = a.cell({x, y}), &v = b.cell({x, y});
      if (u.hits != v.hits || u.visits != v.visits) return false;
      if (u.mean_x != v.mean_x || u.mean_y != v.mean_y) return false;
      if (a.OccupiedBits({x, y}) != b.OccupiedBits({x, y})) return false;
    }
  }
  return true;
}

inline std::vector<backend::SE2> PosesOf(const std::vector<TrajectoryTree::Vertex>& path) {
  std::vector<backend::SE2> poses;
  for (const TrajectoryTree::Vertex& vertex : path) poses.push_back(vertex.world_T_robot);
  return poses;
}

// The map of a path from nothing, one scan after the other.
template <typename ScanOfStep>
map::OccupancyGrid MapFromScratch(const std::vector<backend::SE2>& path,
                                  const ScanOfStep& scan_of_step) {
  map::OccupancyGrid grid({});
  for (std::size_t step = 0; step < path.size(); ++step) {
    map::InsertScan(scan_of_step(static_cast<int>(step)), path[step], {}, &grid);
  }
  return grid;
}

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_SAME_MAP_H_
