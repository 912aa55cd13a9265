#include "frontend/scan_odometry.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "frontend/map/scan_registration.h"

namespace gmapping_spa::frontend {

using backend::SE2;
using scan_matching::ScanPoints;

namespace {

// Gauss-Newton converges from within a step of the lattice.
constexpr double kLinearStep_m = 0.1;
constexpr double kAngularStep_rad = 0.025;

constexpr double kForgetting = 0.05;  // a scan's share in the running mean of the scores

// By how much another place must score higher to be believed against the wheels.
constexpr double kSearchMargin = 0.1;

}  // namespace

ScanOdometry::ScanOdometry(const Options& options)
    : options_(options), matcher_(options.gauss_newton, options.endpoint) {
  CHECK_GT(options.floor_m, 0.0);
  CHECK_GT(options.floor_rad, 0.0);
  CHECK_GE(options.map_scans, 2);
}

SE2 ScanOdometry::Advance(const sensor::LaserScan& scan, const SE2& wheels) {
  if (maps_.empty()) {
    maps_.push_back({map::OccupancyGrid(options_.grid)});
    Enter(scan);
    return {};
  }
  const ScanPoints points = scan_matching::MakeScanPoints(scan);
  const SE2 before = odom_T_robot_;
  const SE2 predicted = before * wheels;
  const map::OccupancyGrid& grid = maps_.front().grid;
  scan_matching::MatchResult match =
      matcher_.Match(grid, points, predicted, WheelInformation(wheels));
  const double usual_score = options_.search_below * recent_score_;
  if (match.score < usual_score) {
    const scan_matching::MatchResult elsewhere =
        matcher_.Match(grid, points, Search(points, predicted, usual_score / 2.0));
    if (elsewhere.score > std::max(usual_score, match.score + kSearchMargin)) match = elsewhere;
  }
  recent_score_ += kForgetting * (match.score - recent_score_);
  odom_T_robot_ = match.success ? match.world_T_robot : predicted;

  const SE2 since_entered = Between(odom_T_entered_, odom_T_robot_);
  if (since_entered.translation().norm() > options_.enter_m ||
      std::abs(since_entered.theta) > options_.enter_rad) {
    Enter(scan);
  }
  return Between(before, odom_T_robot_);
}

// The best pose of a lattice that scores at least so much; the centre if there is none.
SE2 ScanOdometry::Search(const ScanPoints& points, const SE2& centre, double at_least) const {
  scan_matching::EndpointModel model(options_.endpoint, &maps_.front().grid, &points);
  SE2 best = centre;
  double best_score = std::max(model.Score(centre), at_least);
  const int linear = static_cast<int>(std::lround(options_.search_m / kLinearStep_m));
  const int angular = static_cast<int>(std::lround(options_.search_rad / kAngularStep_rad));
  for (int t = -angular; t <= angular; ++t) {
    for (int x = -linear; x <= linear; ++x) {
      for (int y = -linear; y <= linear; ++y) {
        const SE2 candidate{centre.x + kLinearStep_m * x, centre.y + kLinearStep_m * y,
                            backend::WrapAngle(centre.theta + kAngularStep_rad * t)};
        const double score = model.Score(candidate, best_score);
        if (score > best_score) {
          best = candidate;
          best_score = score;
        }
      }
    }
  }
  return best;
}

// The same in all directions, so that the frame does not matter.
Eigen::Matrix3d ScanOdometry::WheelInformation(const SE2& wheels) const {
  const double linear_m = wheels.translation().norm(), angular_rad = std::abs(wheels.theta);
  const double sigma_m = options_.floor_m + options_.m_per_m * linear_m;
  const double sigma_rad =
      options_.floor_rad + options_.rad_per_m * linear_m + options_.rad_per_rad * angular_rad;
  return Eigen::Array3d(sigma_m, sigma_m, sigma_rad).square().inverse().matrix().asDiagonal();
}

// Enters the scan into both maps. The second one is begun when the first is half full, and takes
// its place when that is full: the map in use always holds the last half.
void ScanOdometry::Enter(const sensor::LaserScan& scan) {
  odom_T_entered_ = odom_T_robot_;
  if (maps_.back().scans >= options_.map_scans / 2) {
    if (maps_.size() == 2) maps_.erase(maps_.begin());
    maps_.push_back({map::OccupancyGrid(options_.grid)});
  }
  for (LocalMap& local : maps_) {
    map::RegisterScan(scan, odom_T_robot_, {}, &local.grid);
    ++local.scans;
  }
}

}  // namespace gmapping_spa::frontend
