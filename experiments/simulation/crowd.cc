// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/crowd.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "backend/counter_random.h"
#include "experiments/simulation/random_streams.h"

namespace gmapping_spa::simulation {
namespace {

using backend::CounterRandom;
using backend::SE2;

const Eigen::Vector2d kHalfSizeM(0.12, 0.2);  // from chest to back, from shoulder to shoulder
// A disc about the walker: the corners of the rectangle are in it.
constexpr double kRadiusM = 0.25;
// What walkers keep between themselves and the robot.
constexpr double kDistanceM = 0.2;
constexpr double kNearestEntryM = 4.0, kFarthestEntryM = 10.0, kLeftBehindM = 12.0;
constexpr int kEntryTries = 30;
// How far ahead a walker looks for a free way, in time.
constexpr double kLookaheadS = 1.0;
constexpr double kSlowestM_S = 0.5, kFastestM_S = 1.8;
constexpr double kMaxTurnRateRadS = 3.0;
// The wish to turn is random, with this deviation and memory.
constexpr double kWanderRadS = 0.5, kWanderMemoryS = 2.0;

struct Walker {
  SE2 world_T_walker;
  double speed_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
};

// What walkers must not touch now.
struct Obstacles {
  const World& world;
  Eigen::Vector2d robot;  // in the world frame
  double robot_radius_m;

  bool ClearOfRobot(const Eigen::Vector2d& point) const {
    return (point - robot).norm() > robot_radius_m + kRadiusM + kDistanceM;
  }
  bool Clear(const Eigen::Vector2d& point) const {
    return ClearOfRobot(point) && !world.FindContact(point, kRadiusM);
  }
};

Eigen::Vector2d Ahead(const Eigen::Vector2d& from, double heading_rad, double distance_m) {
  return from + distance_m * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));
}

std::optional<Walker> SpawnWalker(const Obstacles& obstacles, CounterRandom* random) {
  for (int i = 0; i < kEntryTries; ++i) {
    const double distance_m =
        kNearestEntryM + (kFarthestEntryM - kNearestEntryM) * random->Uniform();
    const Eigen::Vector2d point =
        Ahead(obstacles.robot, 2.0 * std::numbers::pi * random->Uniform(), distance_m);
    const double heading_rad = std::numbers::pi * (2.0 * random->Uniform() - 1.0);
    if (!obstacles.Clear(point)) continue;
    const double speed_m_s = std::clamp(1.1 + 0.3 * random->Gaussian(), kSlowestM_S, kFastestM_S);
    return Walker{{point.x(), point.y(), heading_rad}, speed_m_s, 0.0};
  }
  return std::nullopt;
}

// The free way that is nearest to where the walker wants to go; to turn round if there is none.
double FreeHeading(const Obstacles& obstacles, const Walker& walker, double wanted_rad) {
  const Eigen::Vector2d from = walker.world_T_walker.translation();
  const double distance_m = walker.speed_m_s * kLookaheadS;
  for (int i = 0; i <= 9; ++i) {
    for (const double side : {1.0, -1.0}) {
      const double heading_rad = wanted_rad + side * i * std::numbers::pi / 9.0;
      if (obstacles.Clear(Ahead(from, heading_rad, distance_m)) &&
          obstacles.Clear(Ahead(from, heading_rad, distance_m / 2.0))) {
        return heading_rad;
      }
    }
  }
  return wanted_rad + std::numbers::pi;
}

// `obstacles` are those at the end of the step.
void Step(const Obstacles& obstacles, double step_s, CounterRandom* random, Walker* walker) {
  const double keep = std::exp(-step_s / kWanderMemoryS);
  walker->turn_rate_rad_s = keep * walker->turn_rate_rad_s +
                            std::sqrt(1.0 - keep * keep) * kWanderRadS * random->Gaussian();
  SE2& pose = walker->world_T_walker;
  const double wanted_rad = pose.theta + walker->turn_rate_rad_s * step_s;
  const double turn_rad =
      backend::WrapAngle(FreeHeading(obstacles, *walker, wanted_rad) - pose.theta);
  const double most_rad = kMaxTurnRateRadS * step_s;
  pose.theta = backend::WrapAngle(pose.theta + std::clamp(turn_rad, -most_rad, most_rad));
  const Eigen::Vector2d next = Ahead(pose.translation(), pose.theta, walker->speed_m_s * step_s);
  if (!obstacles.Clear(next)) return;  // turns on the spot
  pose.x = next.x();
  pose.y = next.y();
}

}  // namespace

std::optional<Rectangle> Walk::At(double time_s) const {
  // Rounding must not put the time of a step before it, when another walker was there.
  const double at = time_s / step_s_ + 1e-9;
  const std::size_t step = std::min(static_cast<std::size_t>(at), world_T_walker_.size() - 1);
  const std::optional<SE2>& now = world_T_walker_[step];
  if (!now || step + 1 == world_T_walker_.size()) {
    return now ? std::optional(Rectangle{*now, kHalfSizeM}) : std::nullopt;
  }
  const std::optional<SE2>& next = world_T_walker_[step + 1];
  // Who is there next and too far away is someone else.
  const double farthest_m = 1.001 * kFastestM_S * step_s_;
  if (!next || (next->translation() - now->translation()).norm() > farthest_m) {
    return Rectangle{*now, kHalfSizeM};
  }
  const double share = std::min(1.0, at - static_cast<double>(step));
  const Eigen::Vector2d point = (1.0 - share) * now->translation() + share * next->translation();
  const double theta = now->theta + share * backend::WrapAngle(next->theta - now->theta);
  return Rectangle{{point.x(), point.y(), backend::WrapAngle(theta)}, kHalfSizeM};
}

std::vector<Walk> WalkAbout(const World& world, const std::vector<MotionStep>& robot,
                            double robot_radius_m, int walkers, std::uint64_t seed) {
  std::vector<Walk> walks;
  if (robot.size() < 2) return walks;
  const double step_s = robot[1].time_s - robot[0].time_s;
  for (int i = 0; i < walkers; ++i) {
    std::vector<std::optional<SE2>> poses;
    std::optional<Walker> walker;
    for (std::size_t step = 0; step < robot.size(); ++step) {
      CounterRandom random(seed, kCrowdStream, static_cast<std::uint32_t>(step), i);
      const Obstacles obstacles{world, robot[step].world_T_robot.translation(), robot_radius_m};
      if (walker) Step(obstacles, step_s, &random, &*walker);
      const auto stays = [&] {
        const Eigen::Vector2d point = walker->world_T_walker.translation();
        return obstacles.ClearOfRobot(point) && (point - obstacles.robot).norm() < kLeftBehindM;
      };
      if (!walker || !stays()) walker = SpawnWalker(obstacles, &random);
      poses.push_back(walker ? std::optional(walker->world_T_walker) : std::nullopt);
    }
    walks.emplace_back(std::move(poses), step_s);
  }
  return walks;
}

}  // namespace gmapping_spa::simulation
