// SPDX-License-Identifier: BSD-3-Clause
// A world with the obstacles of an experiment.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_SCENE_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_SCENE_H_

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/simulation/crowd.h"
#include "experiments/simulation/pedestrian.h"
#include "experiments/simulation/world.h"

namespace gmapping_spa::simulation {

// What a disc touches, and where.
struct Contact {
  Eigen::Vector2d world_point;
  const char* what;
};

// What stands is part of the world; what walks is not.
struct Scene {
  World world;
  std::optional<Pedestrian> pedestrian;
  std::vector<Walk> crowd;

  Scene(World w, std::optional<Pedestrian> p = std::nullopt)  // NOLINT: a world is a scene
      : world(std::move(w)), pedestrian(std::move(p)) {}

  // Reads a world file and, where `obstacles_path` is not empty, draws a file of obstacles over it:
  // the shapes of DrawShapes, and perhaps a pedestrian by the keys `pedestrian_size: [back to
  // front, shoulder to shoulder]`, `pedestrian_speed` and `pedestrian_way_points`, in m and m/s. A
  // pedestrian that does not walk stands at its first way point, facing the second, and is drawn.
  // Throws std::runtime_error "<path>[:<line>]: <what was expected, what was found>".
  static Scene Read(const std::string& world_path, const std::string& obstacles_path,
                    bool pedestrian_walks);

  // As World::CastRay and World::FindContact, at a time from 0 on.
  std::optional<double> CastRay(const Eigen::Vector2d& world_origin, double world_angle_rad,
                                double max_range_m, double time_s) const;
  std::optional<Contact> FindContact(const Eigen::Vector2d& world_center, double radius_m,
                                     double time_s) const;

 private:
  // Calls `use(rectangle, what)` with all who walk, where they are.
  template <typename Use>
  void ForEachWalker(double time_s, const Use& use) const;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_SCENE_H_
