// SPDX-License-Identifier: BSD-3-Clause
// People who walk about near a robot.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_CROWD_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_CROWD_H_

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "backend/se2.h"
#include "experiments/simulation/robot_motion.h"
#include "experiments/simulation/shapes.h"
#include "experiments/simulation/world.h"

namespace gmapping_spa::simulation {

// One of them, at each step of the robot's motion.
class Walk {
 public:
  Walk(std::vector<std::optional<backend::SE2>> world_T_walker, double step_s)
      : world_T_walker_(std::move(world_T_walker)), step_s_(step_s) {}

  // Where the walker is; between two steps on the line from one to the other. Nothing while there
  // is none. The time must not be negative; after the last step nobody moves.
  std::optional<Rectangle> At(double time_s) const;

 private:
  std::vector<std::optional<backend::SE2>> world_T_walker_;
  double step_s_;
};

// `walkers` people on smooth random ways, 0.5 to 1.8 m/s fast, who touch neither walls nor the
// robot: they walk round it, and who cannot is gone. Who is gone or was left behind, 12 m away, is
// followed by another who comes from 4 to 10 m away, so that there is always a crowd about the
// robot. They do not see each other. The same arguments give the same walks.
std::vector<Walk> WalkAbout(const World& world, const std::vector<MotionStep>& robot,
                            double robot_radius_m, int walkers, std::uint64_t seed);

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_CROWD_H_
