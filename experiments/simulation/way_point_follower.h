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

// Reads `way_points: - [x, y]` from YAML: two or more, no two neighbours the same.
// Throws std::runtime_error "<path>[:<line>]: <what was expected, what was found>".
WayPoints ReadWayPoints(const std::string& path);
// The same of the list at `key`.
WayPoints ReadWayPoints(const map::YamlFile& yaml, const std::string& key);

struct WayPointFollowerOptions {
  double max_speed_m_s = 1.5;
  double max_turn_rate_rad_s = 0.8;
  double max_acceleration_m_s2 = 1.0;
  double max_angular_acceleration_rad_s2 = 2.0;
};

// Aims at a point ahead on the line between two way points, slows down before corners, and turns
// on the spot when the aim is far off its heading.
class WayPointFollower {
 public:
  // The robot starts at the first way point, facing the second.
  WayPointFollower(WayPoints way_points, const WayPointFollowerOptions& options)
      : way_points_(std::move(way_points)), options_(options) {}

  backend::SE2 Start() const;

  // The velocity to drive at for the next `duration_s`. To be called once a control step, with the
  // pose that the last velocity led to.
  BodyVelocity Next(const backend::SE2& world_T_robot, double duration_s);

  // Whether the last way point was reached.
  bool Done() const { return target_ == way_points_.size(); }

 private:
  bool Reached(const Eigen::Vector2d& world_position) const;
  // The highest speed at which the robot can turn towards an aim that is so far off its heading.
  double SpeedLimit(double error_rad) const;
  // Speed at which the target should be passed, given the corner there.
  double CornerSpeed() const;

  WayPoints way_points_;
  WayPointFollowerOptions options_;
  std::size_t target_ = 1;  // index of the way point being driven to
  BodyVelocity velocity_;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_WAY_POINT_FOLLOWER_H_
