// SPDX-License-Identifier: BSD-3-Clause
// Trajectory trees in a long corridor, where a scan sees a small part of the map only.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_MAP_HISTORY_WORLD_H_
#define GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_MAP_HISTORY_WORLD_H_

#include <vector>

#include "backend/counter_random.h"
#include "frontend/particle_filter/map_history.h"
#include "tests/frontend/particle_filter/same_map.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::particle_filter {

// Where the robot was.
inline backend::SE2 TruthOf(int step) { return {0.5 * step, 0.1, step % 2 == 0 ? 0.0 : 0.4}; }

inline sensor::LaserScan CorridorScan(int step) {
  return synthetic::Scan(synthetic::Corridor(0.02), TruthOf(step),
                         {.beams = 61, .usable_range_m = 1.6, .robot_T_laser = {0.1, 0, 0}});
}

// All leaves are at one step, as those of a particle filter.
struct GrownTree {
  explicit GrownTree(std::uint64_t seed) : random(seed, 0) {
    leaves.push_back(tree.AddRoot(Near(0)));
  }

  // A pose that some particle may have had at a step.
  backend::SE2 Near(int step) {
    return TruthOf(step) *
           backend::SE2{0.1 * random.Gaussian(), 0.1 * random.Gaussian(), 0.05 * random.Gaussian()};
  }

  // Each leaf drives on, once.
  void Grow(int steps = 1) {
    for (; steps > 0; --steps) {
      for (TrajectoryTree::Index& leaf : leaves) {
        leaf = tree.Append(leaf, Near(tree.vertices()[leaf].step + 1), {});
      }
    }
  }

  // As by resampling: the leaf at `index` has a twin.
  void Duplicate(int index) { leaves.push_back(leaves[index]); }

  // Moves the poses of all leaves from a step on.
  void MoveFrom(int step, const backend::SE2& motion) {
    for (std::size_t i = 0; i < tree.size(); ++i) {
      if (tree.vertices()[i].step < step) continue;
      tree.SetPose(static_cast<TrajectoryTree::Index>(i),
                   motion * tree.vertices()[i].world_T_robot);
    }
  }

  map::OccupancyGrid FromScratch(int leaf) const {
    return MapFromScratch(PosesOf(tree.Path(leaves[leaf])), CorridorScan);
  }

  TrajectoryTree tree;
  std::vector<TrajectoryTree::Index> leaves;
  backend::CounterRandom random;
};

// Whether each leaf has the map that its path alone leads to.
inline bool AreFromScratch(const std::vector<map::OccupancyGrid>& maps, const GrownTree& grown) {
  if (maps.size() != grown.leaves.size()) return false;
  for (std::size_t k = 0; k < maps.size(); ++k) {
    if (!SameMap(maps[k], grown.FromScratch(static_cast<int>(k)))) return false;
  }
  return true;
}

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_TESTS_FRONTEND_PARTICLE_FILTER_MAP_HISTORY_WORLD_H_
