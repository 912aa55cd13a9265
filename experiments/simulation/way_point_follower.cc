// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/way_point_follower.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gmapping_spa::simulation {
namespace {

// A way point counts as reached this near to it: corners are cut by no more.
constexpr double kReachedM = 0.25;
// How far ahead on the line the robot aims.
constexpr double kLookaheadM = 0.7;
// Beyond this angle between heading and aim the robot does not drive.
constexpr double kTurnOnTheSpotRad = std::numbers::pi / 3.0;
constexpr double kHeadingGainPerS = 2.5;
// Slow enough to pass any corner, fast enough to arrive.
constexpr double kCreepM_S = 0.15;
// So little of a turn is not worth another step.
constexpr double kTurnedRad = 1e-3;
// Front and back swapped.
constexpr backend::SE2 kAboutTurn{0.0, 0.0, std::numbers::pi};

double Direction(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

}  // namespace

std::vector<WayPoints> ReadTours(const std::string& path) {
  const map::YamlFile yaml(path);
  yaml.AllowOnly({"way_points", "carried_to"});
  std::vector<WayPoints> tours = {ReadWayPoints(yaml, "way_points")};
  if (!yaml.Has("carried_to")) return tours;
  for (const YAML::Node& tour : yaml.Items("carried_to"))
    tours.push_back(ReadWayPoints(yaml, tour));
  return tours;
}

WayPoints ReadWayPoints(const map::YamlFile& yaml, const std::string& key) {
  yaml.Items(key);  // a list, or the error names the key
  return ReadWayPoints(yaml, yaml.Get(key));
}

WayPoints ReadWayPoints(const map::YamlFile& yaml, const YAML::Node& list) {
  if (!list.IsSequence()) yaml.Fail(list, "expected a list of way points [x, y]");
  WayPoints way_points;
  for (const YAML::Node& item : list) {
    const std::vector<double> point = yaml.Numbers(item, 2, "a way point [x, y]");
    way_points.emplace_back(point[0], point[1]);
    if (way_points.size() > 1 && way_points.back() == *std::prev(way_points.end(), 2)) {
      yaml.Fail(item, "expected a way point other than the one before, found the same");
    }
  }
  if (way_points.size() < 2) {
    yaml.Fail(list, "expected two or more way points, found " + std::to_string(way_points.size()));
  }
  return way_points;
}

backend::SE2 WayPointFollower::Start() const {
  const backend::SE2 start{way_points_[0].x(), way_points_[0].y(),
                           Direction(way_points_[0], way_points_[1])};
  return options_.reverse ? start * kAboutTurn : start;
}

bool WayPointFollower::Reached(const Eigen::Vector2d& world_position) const {
  return (way_points_[target_] - world_position).norm() < kReachedM;
}

double WayPointFollower::SpeedLimit(double error_rad) const {
  const double share = std::max(0.0, 1.0 - std::abs(error_rad) / kTurnOnTheSpotRad);
  // The circle from here to the aim, at the highest turn rate.
  const double circle_m_s = options_.max_turn_rate_rad_s * kLookaheadM /
                            (2.0 * std::max(std::sin(std::abs(error_rad)), 1e-9));
  return std::min(share * options_.max_speed_m_s, circle_m_s);
}

double WayPointFollower::CornerSpeed() const {
  if (target_ + 1 == way_points_.size() || options_.turns_at_way_points != 0.0) return kCreepM_S;
  const double before = Direction(way_points_[target_ - 1], way_points_[target_]);
  const double after = Direction(way_points_[target_], way_points_[target_ + 1]);
  const double corner_rad = std::abs(backend::WrapAngle(after - before));
  return std::max(kCreepM_S, SpeedLimit(corner_rad));
}

BodyVelocity WayPointFollower::Next(const backend::SE2& world_T_robot, double duration_s) {
  if (!options_.reverse) return velocity_ = NextForwards(world_T_robot, duration_s);
  velocity_ = NextForwards(world_T_robot * kAboutTurn, duration_s);
  return {-velocity_.linear_m_s, velocity_.angular_rad_s};
}

BodyVelocity WayPointFollower::NextForwards(const backend::SE2& world_T_robot, double duration_s) {
  if (turn_left_rad_ != 0.0) return Turn(duration_s);
  const Eigen::Vector2d position = world_T_robot.translation();
  while (!Done() && Reached(position)) {
    ++target_;
    turn_left_rad_ = 2.0 * std::numbers::pi * options_.turns_at_way_points;
    if (turn_left_rad_ != 0.0) return Turn(duration_s);
  }
  if (Done()) return {};

  const Eigen::Vector2d& from = way_points_[target_ - 1];
  const Eigen::Vector2d& to = way_points_[target_];
  const double length_m = (to - from).norm();
  const Eigen::Vector2d along = (to - from) / length_m;
  const double aim_m = std::clamp((position - from).dot(along) + kLookaheadM, 0.0, length_m);
  const Eigen::Vector2d aim = from + aim_m * along;
  const double error_rad = backend::WrapAngle(Direction(position, aim) - world_T_robot.theta);

  const double braking_m = std::max(0.0, (to - position).norm() - kReachedM);
  const double corner_m_s = CornerSpeed();
  const double speed_m_s = std::min(
      SpeedLimit(error_rad),
      std::sqrt(corner_m_s * corner_m_s + 2.0 * options_.max_acceleration_m_s2 * braking_m));
  const double turn_rate_rad_s = std::clamp(
      kHeadingGainPerS * error_rad, -options_.max_turn_rate_rad_s, options_.max_turn_rate_rad_s);
  return Toward({speed_m_s, turn_rate_rad_s}, duration_s);
}

BodyVelocity WayPointFollower::Turn(double duration_s) {
  // Slows down so that it can stop at the end, and does the last bit in one step.
  const double rate_rad_s = std::min(
      {options_.max_turn_rate_rad_s,
       std::sqrt(2.0 * options_.max_angular_acceleration_rad_s2 * std::abs(turn_left_rad_)),
       std::abs(turn_left_rad_) / duration_s});
  const BodyVelocity velocity =
      Toward({0.0, std::copysign(rate_rad_s, turn_left_rad_)}, duration_s);
  const double left_rad = turn_left_rad_ - velocity.angular_rad_s * duration_s;
  const bool done = left_rad * turn_left_rad_ <= 0.0 || std::abs(left_rad) < kTurnedRad;
  turn_left_rad_ = done ? 0.0 : left_rad;
  return velocity;
}

BodyVelocity WayPointFollower::Toward(const BodyVelocity& wanted, double duration_s) const {
  return Accelerate(velocity_, wanted,
                    {options_.max_acceleration_m_s2, options_.max_angular_acceleration_rad_s2},
                    duration_s);
}

}  // namespace gmapping_spa::simulation
