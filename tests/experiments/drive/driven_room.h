// SPDX-License-Identifier: BSD-3-Clause
// A robot with few beams that is driven through a room of 8 m x 6 m.
#ifndef GMAPPING_SPA_TESTS_EXPERIMENTS_DRIVE_DRIVEN_ROOM_H_
#define GMAPPING_SPA_TESTS_EXPERIMENTS_DRIVE_DRIVEN_ROOM_H_

#include <vector>

#include "experiments/drive/driven_robot.h"
#include "experiments/drive/recorded_tour.h"
#include "tests/experiments/simulation/room.h"

namespace gmapping_spa::drive {

inline simulation::SimulationOptions RoomOptions() {
  simulation::SimulationOptions options;
  options.lidar.beams = 180;
  options.robot_radius_m = 0.3;
  options.seed = 5;
  return options;
}

inline const simulation::Scene& RoomScene() {
  static const auto& scene = *new simulation::Scene(simulation::Room());
  return scene;
}

struct DrivenRoom {
  RecordedTour tour{RoomOptions().lidar};
  DrivenRobot robot{&RoomScene(), {2.0, 3.0, 0.0}, RoomOptions()};

  void Drive(const simulation::BodyVelocity& velocity, int scans) {
    for (int i = 0; i < scans; ++i) tour.Drive({velocity, noise, slips_per_m}, &robot);
  }
  double noise = 1.0, slips_per_m = 0.01;
};

}  // namespace gmapping_spa::drive

#endif  // GMAPPING_SPA_TESTS_EXPERIMENTS_DRIVE_DRIVEN_ROOM_H_
