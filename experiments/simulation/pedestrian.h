// SPDX-License-Identifier: BSD-3-Clause
// Someone who walks to and fro.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_PEDESTRIAN_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_PEDESTRIAN_H_

#include <Eigen/Core>

#include "experiments/simulation/shapes.h"
#include "experiments/simulation/way_point_follower.h"

namespace gmapping_spa::simulation {

// Where the pedestrian is depends on the time alone.
struct Pedestrian {
  Eigen::Vector2d size_m;  // from back to front, from shoulder to shoulder
  double speed_m_s = 0.0;
  WayPoints way_points;  // two or more

  // At time 0 at the first way point, facing the second; turns at the last one and the first one.
  Rectangle At(double time_s) const;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_PEDESTRIAN_H_
