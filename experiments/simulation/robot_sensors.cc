// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/robot_sensors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gmapping_spa::simulation {
namespace {

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

void RobotSensors::Read(const Scene& scene, const MotionStep& step, LogSink* sink) {
  const double step_s = 1.0 / StepsPerSecond(options_.lidar);
  const OdometryReading reading = ReadingOf(odometry_, step.time_s);
  sink->OnOdometry(reading);
  const bool scans = !step.carried && !Within(options_.without_scan, step.time_s);
  if (scans && steps_ % kStepsPerScan == 0) {
    const auto scan = static_cast<std::uint32_t>(steps_ / kStepsPerScan);
    sink->OnScan(reading, options_.lidar, RangesAt(scene, step, scan, options_));
    summary_.world_T_robot.push_back({reading.stamp_s, step.world_T_robot});
  }
  odometry_.Integrate(step.after, step_s);
  summary_.path_length_m += std::abs(step.after.linear_m_s) * step_s;
  ++steps_;
}

SimulationSummary RobotSensors::Summary() const {
  SimulationSummary summary = summary_;
  summary.odom_T_robot = odometry_.odom_T_robot();
  summary.slips = odometry_.slips();
  summary.bumps = odometry_.bumps();
  return summary;
}

}  // namespace gmapping_spa::simulation
