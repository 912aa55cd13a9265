// SPDX-License-Identifier: BSD-3-Clause
// The map that a perfect mapper would make of a world.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_TRUTH_MAP_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_TRUTH_MAP_H_

#include <Eigen/Core>

#include "experiments/simulation/world.h"

namespace gmapping_spa::simulation {

// Cells of the world are
//   free when a point can get there from `world_start` through empty cells that share an edge;
//   occupied when they are solid and share an edge or a corner with a free cell: what can be seen;
//   unknown otherwise: the inside of solids, and rooms without a door.
// A cell of the map, several cells of the world wide where resolution_m is coarser, is occupied
// when any of its cells is, else free when any is. Throws std::runtime_error when resolution_m is
// not a multiple of the world's or `world_start` is not in an empty cell.
map::TrinaryMap TruthMap(const World& world, const Eigen::Vector2d& world_start,
                         double resolution_m);

// What stands in a world and not in the same one without it: the true map of the one, unknown where
// that of the other is occupied. Throws std::invalid_argument when their
// grids differ.
map::TrinaryMap Added(const map::TrinaryMap& truth, const map::TrinaryMap& truth_of_empty_world);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_TRUTH_MAP_H_
