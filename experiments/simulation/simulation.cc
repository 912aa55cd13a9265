// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/simulation.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "backend/text.h"
#include "experiments/simulation/crowd.h"
#include "experiments/simulation/robot_motion.h"
#include "experiments/simulation/robot_sensors.h"

namespace gmapping_spa::simulation {
namespace {

std::string ToString(const Eigen::Vector2d& point) {
  return "(" + backend::FixedText(point.x(), 2) + ", " + backend::FixedText(point.y(), 2) + ")";
}

void CheckFree(const Scene& scene, const backend::SE2& world_T_robot, double radius_m,
               double time_s) {
  const std::optional<Contact> contact =
      scene.FindContact(world_T_robot.translation(), radius_m, time_s);
  if (!contact) return;
  throw std::runtime_error("tour: expected free space around the robot at " +
                           ToString(world_T_robot.translation()) + ", found " + contact->what +
                           " at " + ToString(contact->world_point));
}

}  // namespace

SimulationSummary Simulate(const Scene& world_scene, const WayPoints& way_points,
                           const SimulationOptions& options, LogSink* sink) {
  std::vector<WayPoints> tours = {way_points};
  tours.insert(tours.end(), options.carried_to.begin(), options.carried_to.end());
  const std::vector<MotionStep> motion = DriveTours(
      tours, options.follower, RobotSensors::StepsPerSecond(options.lidar), options.carry_s);
  Scene scene = world_scene;
  scene.crowd =
      WalkAbout(scene.world, motion, options.robot_radius_m, options.walkers, options.seed);

  RobotSensors sensors(options);
  for (const MotionStep& step : motion) {
    if (!step.carried) {
      CheckFree(scene, step.world_T_robot, options.robot_radius_m, step.time_s);
    }
    sensors.Read(scene, step, sink);
  }
  SimulationSummary summary = sensors.Summary();
  if (summary.world_T_robot.empty()) {
    throw std::runtime_error("tour: expected a scan, found none at any time that is left for them");
  }
  return summary;
}

}  // namespace gmapping_spa::simulation
