// Where a scan may fit that does not fit where it was expected.
#include <algorithm>
#include <cmath>
#include <vector>

#include "frontend/scan_odometry.h"

namespace gmapping_spa::frontend {

using backend::SE2;

namespace {

// About so many, evenly spread, tell where a scan fits; what is found is aligned by all beams.
constexpr std::size_t kSearchBeams = 100;

}  // namespace

// The motions around which windows of this size are searched: each guess, and standing still, as
// the robot may have been stopped. A window holds what is near its middle.
std::vector<SE2> ScanOdometry::SearchCentres(const MotionPrior& prior,
                                             const scan_matching::SearchWindow& window) {
  std::vector<SE2> centres;
  const auto add = [&](const SE2& motion) {
    const bool is_held = std::any_of(centres.begin(), centres.end(), [&](const SE2& centre) {
      const SE2 off = Between(centre, motion);
      return off.translation().norm() < 0.5 * window.linear_m &&
             std::abs(off.theta) < 0.5 * window.angular_rad;
    });
    if (!is_held) centres.push_back(motion);
  };
  for (const MotionHypothesis& hypothesis : prior.hypotheses()) add(hypothesis.motion);
  add(SE2{});
  return centres;
}

// The best and the second best match of a window.
std::vector<ScanOdometry::Match> ScanOdometry::Search(const SE2& centre,
                                                      const scan_matching::SearchWindow& window) {
  std::vector<Eigen::Vector2d> positions;
  double reach_m = 1.0;
  const std::size_t stride = 1 + points_.size() / kSearchBeams;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const scan_matching::ScanPoint& point = points_[k];
    if (k % stride == 0) positions.emplace_back(point.x_m, point.y_m);
    reach_m = std::max(reach_m, std::hypot(point.x_m, point.y_m));
  }
  scan_matching::CorrelativeMatcher::Options search;
  search.min_score = 0.2;
  search.second_floor = 0.8;
  search.peak_separation_m = 0.2;
  search.with_covariance = false;
  const scan_matching::CorrelativeMatch found =
      map_.Search(search, odom_T_robot_, reach_m + 1.5).Match(positions, centre, window);
  std::vector<Match> matches;
  if (!found.found) return matches;
  const MotionHypothesis weak{.motion = {}, .sigma_m = 0.1, .sigma_rad = 0.1};
  matches.push_back(Track(found.map_T_scan, weak));
  if (found.second_map_T_scan != found.map_T_scan) {
    matches.push_back(Track(found.second_map_T_scan, weak));
  }
  return matches;
}

}  // namespace gmapping_spa::frontend
