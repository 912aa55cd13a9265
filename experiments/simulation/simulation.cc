#include "experiments/simulation/simulation.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace gmapping_spa::simulation {
namespace {

// A step is half a turn of the laser: what Sweep relies on.
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

double Rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit; }

OdometryReading ReadingOf(const Odometry& odometry, double stamp_s) {
  const auto rounded = [](double value) { return Rounded(value, 1e6); };
  const backend::SE2& pose = odometry.odom_T_robot();
  const BodyVelocity& velocity = odometry.measured_velocity();
  return {rounded(stamp_s),
          {rounded(pose.x), rounded(pose.y), rounded(pose.theta)},
          {rounded(velocity.linear_m_s), rounded(velocity.angular_rad_s)}};
}

}  // namespace

SimulationSummary Simulate(const Scene& scene, const WayPoints& way_points,
                           const SimulationOptions& options, LogSink* sink) {
  const double step_s = 1.0 / (options.lidar.rate_hz * kStepsPerScan);
  const double limit_s = TimeLimit(way_points, options.follower);
  WayPointFollower follower(way_points, options.follower);
  Odometry odometry(options.odometry, options.seed);

  SimulationSummary summary;
  backend::SE2 world_T_robot = follower.Start();
  BodyVelocity velocity;
  for (std::int64_t step = 0; !follower.Done(); ++step) {
    // Not a sum of steps: stamps must not drift.
    const double time_s =
        static_cast<double>(step) / (options.lidar.rate_hz * static_cast<double>(kStepsPerScan));
    if (time_s > limit_s) {
      throw std::runtime_error("tour: expected to reach every way point, found the robot at " +
                               Describe(world_T_robot.translation()) + " after " +
                               std::to_string(limit_s) + " s");
    }
    CheckFree(scene, world_T_robot, options.robot_radius_m, time_s);
    const BodyVelocity next_velocity = follower.Next(world_T_robot, step_s);
    const OdometryReading reading = ReadingOf(odometry, time_s);
    sink->OnOdometry(reading);
    if (step % kStepsPerScan == 0) {
      std::vector<double> ranges_m =
          Scan(scene, {time_s, world_T_robot, velocity, next_velocity}, options.lidar, options.seed,
               static_cast<std::uint32_t>(step / kStepsPerScan));
      for (double& range_m : ranges_m) range_m = Rounded(range_m, 1e3);
      sink->OnScan(reading, options.lidar, ranges_m);
      summary.world_T_robot.push_back({reading.stamp_s, world_T_robot});
    }
    velocity = next_velocity;
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
