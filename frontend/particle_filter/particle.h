// SPDX-License-Identifier: BSD-3-Clause
// One hypothesis of the Rao-Blackwellized filter.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARTICLE_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARTICLE_H_

#include "backend/se2.h"
#include "frontend/map/occupancy_grid.h"
#include "frontend/particle_filter/trajectory_tree.h"

namespace gmapping_spa::particle_filter {

struct Particle {
  backend::SE2 world_T_robot;
  double log_weight = 0.0;      // since the last resampling
  double log_likelihood = 0.0;  // of the whole path, inherited from its ancestors
  map::OccupancyGrid map;
  TrajectoryTree::Index leaf = TrajectoryTree::kNone;
  TrajectoryTree::Motion motion;  // of the latest step

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(world_T_robot, log_weight, log_likelihood, map, leaf, motion);
  }
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PARTICLE_H_
