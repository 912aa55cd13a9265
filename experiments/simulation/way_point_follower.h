// SPDX-License-Identifier: BSD-3-Clause
// A controller that drives a robot along a polyline of way points.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_WAY_POINT_FOLLOWER_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_WAY_POINT_FOLLOWER_H_

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "backend/se2.h"
#include "experiments/simulation/differential_drive.h"
#include "frontend/map/yaml_file.h"

namespace gmapping_spa::simulation {

// Positions in the world frame, in metres.
using WayPoints = std::vector<Eigen::Vector2d>;

// Reads the way points of a tour from YAML: `way_points: - [x, y]`, two or more, no two neighbors
// the same; and of those that follow where the robot is carried from the end of each to the start
// of the next: `carried_to: - [[x, y], [x, y], ...]`.
// Throws std::runtime_error "<path>[:<line>]: <what was expected, what was found>".
std::vector<WayPoints> ReadTours(const std::string& path);
// Way points alone, from a list at `key`, or from a list.
WayPoints ReadWayPoints(const map::YamlFile& yaml, const std::string& key);
WayPoints ReadWayPoints(const map::YamlFile& yaml, const YAML::Node& list);

struct WayPointFollowerOptions {
  double max_speed_m_s = 1.5;
  double max_turn_rate_rad_s = 0.8;
  double max_acceleration_m_s2 = 1.0;
  double max_angular_acceleration_rad_s2 = 2.0;
  bool reverse = false;  // drives backwards all the way
  // Full turns on the spot at each way point but the first; counter-clockwise when positive.
  double turns_at_way_points = 0.0;
};

// Aims at a point ahead on the line between two way points, slows down before corners, and turns
// on the spot when the aim is far off its heading.
class WayPointFollower {
 public:
  // The robot starts at the first way point, facing the second, or with its back to it in reverse.
  WayPointFollower(WayPoints way_points, const WayPointFollowerOptions& options)
      : way_points_(std::move(way_points)), options_(options) {}

  backend::SE2 Start() const;

  // The velocity to drive at for the next `duration_s`. To be called once a control step, with the
  // pose that the last velocity led to.
  BodyVelocity Next(const backend::SE2& world_T_robot, double duration_s);

  // Whether the last way point was reached, and all turns there made.
  bool Done() const { return target_ == way_points_.size() && turn_left_rad_ == 0.0; }

 private:
  // As if it drove forwards: in reverse, front and back are swapped.
  BodyVelocity NextForwards(const backend::SE2& world_T_robot, double duration_s);
  // A step of the turns at a way point.
  BodyVelocity Turn(double duration_s);
  // As near to `wanted` as the accelerations allow.
  BodyVelocity Toward(const BodyVelocity& wanted, double duration_s) const;
  bool Reached(const Eigen::Vector2d& world_position) const;
  // The highest speed at which the robot can turn towards an aim that is so far off its heading.
  double SpeedLimit(double error_rad) const;
  // Speed at which the target should be passed, given the corner there.
  double CornerSpeed() const;

  WayPoints way_points_;
  WayPointFollowerOptions options_;
  std::size_t target_ = 1;      // index of the way point being driven to
  BodyVelocity velocity_;       // the last one, forwards
  double turn_left_rad_ = 0.0;  // on the spot, before it drives on
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_WAY_POINT_FOLLOWER_H_
