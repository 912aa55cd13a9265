#include "experiments/simulation/simulation.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

#include "experiments/simulation/carmen_writer.h"

namespace gmapping_spa::simulation {
namespace {

constexpr std::int64_t kStepsPerScan = 2;

std::string Describe(const Eigen::Vector2d& point) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "(%.2f, %.2f)", point.x(), point.y());
  return text.data();
}

void CheckFree(const Scene& scene, const backend::SE2& world_T_robot, double radius_m,
               double time_s) {
  const std::optional<Contact> contact =
      scene.FindContact(world_T_robot.translation(), radius_m, time_s);
  if (!contact) return;
  throw std::runtime_error("tour: expected free space around the robot at " +
                           Describe(world_T_robot.translation()) + ", found " + contact->what +
                           " at " + Describe(contact->world_point));
}

// Much more time than any tour needs: driven at a tenth of the speed, with a full turn at each way
// point.
double TimeLimit(const WayPoints& way_points, const WayPointFollowerOptions& options) {
  double limit_s = 0.0;
  for (std::size_t i = 1; i < way_points.size(); ++i) {
    limit_s += 10.0 * (way_points[i] - way_points[i - 1]).norm() / options.max_speed_m_s + 10.0 +
               2.0 * std::numbers::pi / options.max_turn_rate_rad_s;
  }
  return limit_s;
}

}  // namespace

SimulationSummary Simulate(const Scene& scene, const WayPoints& way_points,
                           const SimulationOptions& options, std::ostream& log,
                           const std::function<void()>& after_scan) {
  const double step_s = 1.0 / (options.lidar.rate_hz * kStepsPerScan);
  const double limit_s = TimeLimit(way_points, options.follower);
  WayPointFollower follower(way_points, options.follower);
  Odometry odometry(options.odometry, options.seed);
  CarmenWriter writer(log);
  writer.WriteComment("CARMEN log of a simulated robot");
  writer.WriteComment("ODOM x y theta tv rv accel ipc_timestamp ipc_hostname logger_timestamp");
  writer.WriteComment(
      "ROBOTLASER1 laser_type start_angle field_of_view angular_resolution maximum_range accuracy "
      "remission_mode num_readings [ranges] num_remissions [remissions] laser_x laser_y "
      "laser_theta robot_x robot_y robot_theta laser_tv laser_rv forward_safety_dist "
      "side_safety_dist turn_axis ipc_timestamp ipc_hostname logger_timestamp");

  SimulationSummary summary;
  backend::SE2 world_T_robot = follower.Start();
  for (std::int64_t step = 0; !follower.Done(); ++step) {
    // Not a sum of steps: stamps must not drift.
    const double stamp_s =
        static_cast<double>(step) / (options.lidar.rate_hz * static_cast<double>(kStepsPerScan));
    if (stamp_s > limit_s) {
      throw std::runtime_error("tour: expected to reach every way point, found the robot at " +
                               Describe(world_T_robot.translation()) + " after " +
                               std::to_string(limit_s) + " s");
    }
    CheckFree(scene, world_T_robot, options.robot_radius_m, stamp_s);
    writer.WriteOdometry(stamp_s, odometry.odom_T_robot(), odometry.measured_velocity());
    if (step % kStepsPerScan == 0) {
      const std::vector<double> ranges_m =
          Scan(scene, stamp_s, world_T_robot, options.lidar, options.seed,
               static_cast<std::uint32_t>(step / kStepsPerScan));
      writer.WriteScan(stamp_s, odometry.odom_T_robot(), odometry.measured_velocity(),
                       options.lidar, ranges_m);
      summary.world_T_robot.push_back({stamp_s, world_T_robot});
      after_scan();
    }
    const BodyVelocity velocity = follower.Next(world_T_robot, step_s);
    world_T_robot = Drive(world_T_robot, velocity, step_s);
    odometry.Advance(velocity, step_s);
    summary.path_length_m += std::abs(velocity.linear_m_s) * step_s;
  }
  summary.odom_T_robot = odometry.odom_T_robot();
  summary.slips = odometry.slips();
  summary.bumps = odometry.bumps();
  return summary;
}

}  // namespace gmapping_spa::simulation
