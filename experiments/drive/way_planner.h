// SPDX-License-Identifier: BSD-3-Clause
// Ways through a world that is known.
#ifndef GMAPPING_SPA_EXPERIMENTS_DRIVE_WAY_PLANNER_H_
#define GMAPPING_SPA_EXPERIMENTS_DRIVE_WAY_PLANNER_H_

#include <Eigen/Core>

#include "experiments/simulation/way_point_follower.h"
#include "experiments/simulation/world.h"

namespace gmapping_spa::drive {

// A short way (A* on a grid of 0.1 m, then straightened) from `start` to `goal` for a disc that
// keeps a little more than its radius away from all that stands, as far as start and goal allow;
// both are on it. Empty when there is none. Who walks is not thought of.
simulation::WayPoints PlanWay(const simulation::World& world, const Eigen::Vector2d& start,
                              const Eigen::Vector2d& goal, double radius_m);

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_EXPERIMENTS_DRIVE_WAY_PLANNER_H_
