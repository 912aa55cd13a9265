// SPDX-License-Identifier: BSD-3-Clause
// Where a scan may fit that does not fit where it was expected.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "frontend/lidar_odometry.h"
#include "frontend/scan_matching/seen_through.h"

namespace gmapping_spa::frontend {

using backend::SE2;

namespace {

// About so many, evenly spread, tell where a scan fits; what is found is aligned by all beams.
constexpr std::size_t kSearchBeams = 100;
constexpr int kPeaksAfterUnseenWay = 10;

// Half widths of the windows that are searched, one after the other until a match convinces.
struct Window {
  double linear_m, angular_rad;
};
constexpr Window kWindows[] = {{0.3, 0.4}, {0.75, 1.2}, {1.5, 3.14159}};

// Peaks of the fit are about so far apart: alignment from farther off may end in the next one.
constexpr double kPeak_rad = 0.06;

// A way is told where the scan fits this much worse so much farther on, and farther back.
constexpr double kTold_nats = 3.0;
constexpr double kAlong_m = 0.2;
constexpr std::array<double, 2> kSides = {-1.0, 1.0};
constexpr double kSomeMotion_m = 0.01;

}  // namespace

// The motions around which windows of this size are searched: each guess, and standing still, as
// the robot may have been stopped. A window holds what is near its middle.
std::vector<SE2> LidarOdometry::SearchCenters(const MotionPrior& prior,
                                              const scan_matching::SearchWindow& window) {
  std::vector<SE2> centers;
  const auto add = [&](const SE2& motion) {
    const bool is_held = std::any_of(centers.begin(), centers.end(), [&](const SE2& center) {
      const SE2 off = Between(center, motion);
      return off.translation().norm() < 0.5 * window.linear_m &&
             std::abs(off.theta) < 0.5 * window.angular_rad;
    });
    if (!is_held) centers.push_back(motion);
  };
  for (const MotionHypothesis& hypothesis : prior.hypotheses()) add(hypothesis.motion);
  add(SE2{});
  return centers;
}

// Far behind a wall all is unseen, which is no evidence: a pose from where beams have to pass
// through walls to get there would look as good as one that fits.
void LidarOdometry::CountBehindWalls(Match* match) const {
  const scan_matching::SeenThrough through =
      scan_matching::CountSeenThrough(map_.grid(), points_, match->odom_T_robot);
  match->seen_through = through.all;
  const double behind = std::min(match->evidence.unknown, through.into_unseen);
  match->evidence.unknown -= behind;
  match->evidence.contradicted += behind;
}

// Whether the scan fits about as well farther on or farther back on the way of this motion.
bool LidarOdometry::FitsAlong(const Match& match, const SE2& motion) const {
  const double way_m = motion.translation().norm();
  if (map_.empty() || way_m < kSomeMotion_m) return false;
  scan_matching::EndpointModel model(options_.endpoint, &map_.grid(), &points_);
  const Eigen::Vector2d along_m = kAlong_m / way_m * motion.translation();
  const SE2 before = match.odom_T_robot * Inverse(motion);
  return std::any_of(kSides.begin(), kSides.end(), [&](double side) {
    Match moved = match;
    const Eigen::Vector2d to = motion.translation() + side * along_m;
    moved.evidence = model.Evaluate(before * SE2{to.x(), to.y(), motion.theta});
    return Nats(match, 0.0) - Nats(moved, 0.0) < kTold_nats;
  });
}

// Whether a turn is known so badly, by its standard deviation, that the fit near by may be that of
// the next peak. Wheels that are late, or scans that are seldom, leave it open as the robot turns;
// without wheels, always.
bool LidarOdometry::MayLeadToNextPeak(const MotionPrior& prior, bool by_wheels) {
  const MotionHypothesis& guess = prior.hypotheses().front();
  return guess.sigma_rad > kPeak_rad && (!by_wheels || std::abs(guess.motion.theta) > kPeak_rad);
}

// Adds what larger and larger windows have, best first, until one convinces; returns whether there
// was a need. `search_anyway`: the first window in any case.
bool LidarOdometry::SearchUntilOneConvinces(const MotionPrior& prior, bool search_anyway,
                                            std::vector<Match>* matches) {
  bool searched = false;
  for (const Window& window : kWindows) {
    if (IsConvincing(matches->front(), prior) && (searched || !search_anyway)) break;
    searched = true;
    const scan_matching::SearchWindow within{std::min(window.linear_m, prior.reach_m()),
                                             std::min(window.angular_rad, prior.reach_rad())};
    for (const SE2& center : SearchCenters(prior, within)) {
      for (Match& match : Search(odom_T_robot_ * center, within)) {
        CountBehindWalls(&match);
        matches->push_back(match);
      }
    }
    Rank(prior, matches);
  }
  return searched;
}

// The best matches of a window: two, or more after a way without scans, when much of what the
// robot sees at the right one is new, and places that it has seen before score higher.
std::vector<LidarOdometry::Match> LidarOdometry::Search(const SE2& center,
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
  search.runner_up_floor = drove_unseen_ ? 0.4 : 0.8;
  search.peak_separation_m = 0.2;
  search.with_covariance = false;
  std::vector<Match> matches;
  const MotionHypothesis weak{.motion = {}, .sigma_m = 0.1, .sigma_rad = 0.1};
  for (const scan_matching::ScoredPose& peak :
       map_.Search(search, odom_T_robot_, reach_m + 1.5)
           .Peaks(positions, center, window, drove_unseen_ ? kPeaksAfterUnseenWay : 2)) {
    matches.push_back(Track(peak.map_T_scan, weak));
  }
  return matches;
}

}  // namespace gmapping_spa::frontend
