// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/robot_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>

#include "backend/text.h"

namespace gmapping_spa::simulation {
namespace {

// Much more time than any tour needs: driven at a tenth of the speed, with a full turn at each way
// point on top of those that are wanted there.
double TimeLimit(const WayPoints& way_points, const WayPointFollowerOptions& options) {
  const double turns = 1.0 + 2.0 * std::abs(options.turns_at_way_points);
  double limit_s = 0.0;
  for (std::size_t i = 1; i < way_points.size(); ++i) {
    limit_s += 10.0 * (way_points[i] - way_points[i - 1]).norm() / options.max_speed_m_s + 10.0 +
               turns * 2.0 * std::numbers::pi / options.max_turn_rate_rad_s;
  }
  return limit_s;
}

[[noreturn]] void FailToArrive(const backend::SE2& world_T_robot, double limit_s) {
  using backend::FixedText;
  throw std::runtime_error("tour: expected to reach every way point, found the robot at (" +
                           FixedText(world_T_robot.x, 2) + ", " + FixedText(world_T_robot.y, 2) +
                           ") after " + FixedText(limit_s, 0) + " s");
}

}  // namespace

std::vector<MotionStep> DriveTours(const std::vector<WayPoints>& tours,
                                   const WayPointFollowerOptions& options, double steps_per_s,
                                   double carry_s) {
  const double step_s = 1.0 / steps_per_s;
  std::vector<MotionStep> steps;
  // Not a sum of steps: stamps must not drift.
  const auto now_s = [&] { return static_cast<double>(steps.size()) / steps_per_s; };
  for (const WayPoints& way_points : tours) {
    WayPointFollower follower(way_points, options);
    backend::SE2 world_T_robot = follower.Start();
    if (!steps.empty()) {
      const MotionStep end = steps.back();
      const auto carried = std::max<std::int64_t>(1, std::llround(carry_s * steps_per_s));
      for (std::int64_t i = 0; i < carried; ++i) {
        steps.push_back({now_s(), end.world_T_robot, {}, {}, true});
      }
    }
    const double limit_s = now_s() + TimeLimit(way_points, options);
    BodyVelocity velocity;
    while (!follower.Done()) {
      if (now_s() > limit_s) FailToArrive(world_T_robot, limit_s);
      const BodyVelocity next_velocity = follower.Next(world_T_robot, step_s);
      steps.push_back({now_s(), world_T_robot, velocity, next_velocity});
      velocity = next_velocity;
      world_T_robot = Drive(world_T_robot, velocity, step_s);
    }
  }
  return steps;
}

}  // namespace gmapping_spa::simulation
