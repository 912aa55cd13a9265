// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "backend/text.h"
#include "experiments/simulation/crowd.h"
#include "experiments/simulation/robot_motion.h"

namespace gmapping_spa::simulation {
namespace {

// A step is half a turn of the laser: what Sweep relies on.
constexpr std::size_t kStepsPerScan = 2;

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

bool Within(const std::vector<TimeSpan>& spans, double time_s) {
  return std::any_of(spans.begin(), spans.end(), [&](const TimeSpan& span) {
    return time_s >= span.begin_s && time_s < span.end_s;
  });
}

OdometryReading ReadingOf(const Odometry& odometry, double stamp_s) {
  const BodyVelocity& velocity = odometry.measured_velocity();
  return {LoggedNumber(stamp_s),
          LoggedPose(odometry.odom_T_robot()),
          {LoggedNumber(velocity.linear_m_s), LoggedNumber(velocity.angular_rad_s)}};
}

std::vector<double> RangesAt(const Scene& scene, const MotionStep& step, std::uint32_t scan,
                             const SimulationOptions& options) {
  if (Within(options.covered, step.time_s)) {
    return std::vector<double>(options.lidar.beams,
                               std::min(options.covered_range_m, options.lidar.max_range_m));
  }
  std::vector<double> ranges_m =
      Scan(scene, {step.time_s, step.world_T_robot, step.before, step.after}, options.lidar,
           options.seed, scan);
  for (double& range_m : ranges_m) range_m = std::round(range_m * 1e3) / 1e3;
  return ranges_m;
}

}  // namespace

SimulationSummary Simulate(const Scene& world_scene, const WayPoints& way_points,
                           const SimulationOptions& options, LogSink* sink) {
  std::vector<WayPoints> tours = {way_points};
  tours.insert(tours.end(), options.carried_to.begin(), options.carried_to.end());
  const double steps_per_s = options.lidar.rate_hz * static_cast<double>(kStepsPerScan);
  const std::vector<MotionStep> motion =
      DriveTours(tours, options.follower, steps_per_s, options.carry_s);
  Scene scene = world_scene;
  scene.crowd =
      WalkAbout(scene.world, motion, options.robot_radius_m, options.walkers, options.seed);

  Odometry odometry(options.odometry, options.seed);
  SimulationSummary summary;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const MotionStep& step = motion[i];
    if (!step.carried) {
      CheckFree(scene, step.world_T_robot, options.robot_radius_m, step.time_s);
    }
    const OdometryReading reading = ReadingOf(odometry, step.time_s);
    sink->OnOdometry(reading);
    const bool scans = !step.carried && !Within(options.without_scan, step.time_s);
    if (scans && i % kStepsPerScan == 0) {
      const auto scan = static_cast<std::uint32_t>(i / kStepsPerScan);
      sink->OnScan(reading, options.lidar, RangesAt(scene, step, scan, options));
      summary.world_T_robot.push_back({reading.stamp_s, step.world_T_robot});
    }
    odometry.Integrate(step.after, 1.0 / steps_per_s);
    summary.path_length_m += std::abs(step.after.linear_m_s) / steps_per_s;
  }
  if (summary.world_T_robot.empty()) {
    throw std::runtime_error("tour: expected a scan, found none at any time that is left for them");
  }
  summary.odom_T_robot = odometry.odom_T_robot();
  summary.slips = odometry.slips();
  summary.bumps = odometry.bumps();
  return summary;
}

}  // namespace gmapping_spa::simulation
