#include "frontend/scan_odometry.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gmapping_spa::frontend {

using backend::SE2;
using scan_matching::CorrelativeMatch;
using sensor::OdometryFault;

namespace {

constexpr double kForgetting = 0.05;  // a scan's share in the running mean of the fit
constexpr double kMinUsualFit = 0.3;

// Time between scans, s: stamps jitter, and are lost for long.
constexpr double kMinDuration_s = 0.02;
constexpr double kMaxDuration_s = 1.0;
constexpr double kMaxRatio = 2.0;  // of the times of two scans in succession
constexpr double kVelocityGain = 0.7;
constexpr double kSlowDown = 0.8;  // of a robot whose scans do not fit

// Squared standard deviations by which a motion may differ from a guess that it agrees with.
constexpr double kAgrees = 9.0;

// Nats of a beam that fits: neighbouring beams are not independent.
constexpr double kNatsPerBeam = 0.5;
// A scan that fits nowhere (a covered laser, a crowd) says nothing about the motion, at this price.
constexpr double kGarbage_nats = 30.0;

// Part of the beams that may end in unseen space more than at another pose before it counts.
constexpr double kFreeUnknown = 0.1;

// Alternatives that are less likely than the best by this factor, e^-nats, are no alternatives.
constexpr double kAmbiguous_nats = 3.0;
// Matches nearer to each other than this are the same.
constexpr double kSame_m = 0.1;
constexpr double kSame_rad = 0.05;

// Of beams in doubt: fewer that do not fit prove nothing.
constexpr double kFewBeams = 4.0;

// Half widths of the windows that are searched, one after the other until a match convinces.
struct Window {
  double linear_m, angular_rad;
};
constexpr Window kWindows[] = {{0.3, 0.4}, {0.75, 1.2}, {1.5, 3.14159}};

constexpr int kSilentScans = 3;
constexpr double kMinWheelsWrong = 0.01;
constexpr double kMaxWheelsWrong = 0.5;
constexpr double kMaxWheelError = 100.0;

// More than what scan matching is off by.
bool Moves(const SE2& motion) {
  return motion.translation().norm() > 0.02 || std::abs(motion.theta) > 0.01;
}

bool IsSame(const SE2& a, const SE2& b) {
  const SE2 off = Between(a, b);
  return off.translation().norm() < kSame_m && std::abs(off.theta) < kSame_rad;
}

}  // namespace

ScanOdometry::ScanOdometry(const Options& options)
    : options_(options),
      matcher_(options.gauss_newton, options.endpoint),
      map_(options.grid, options.map_scans) {}

ScanMotion ScanOdometry::Advance(const sensor::LaserScan& scan,
                                 const sensor::OdometryCheck::Step& wheels) {
  if (map_.empty()) {
    map_.Enter(scan, odom_T_robot_);
    stamp_s_ = scan.stamp_s;
    return {};
  }
  const double duration_s =
      std::clamp(scan.stamp_s - stamp_s_, kMinDuration_s, kMaxDuration_s);
  stamp_s_ = scan.stamp_s;
  usual_duration_s_ += kForgetting * (duration_s - usual_duration_s_);
  const SE2 before = odom_T_robot_;
  ScanMotion result;
  if (wheels.fault == OdometryFault::kRepeatedScan) {  // the scan is of no use
    odom_T_robot_ = before * wheels.motion;
    result.motion = wheels.motion;
    result.matched = false;
    return result;
  }

  points_ = scan_matching::MakeScanPoints(scan);
  const MotionPrior prior = MakePrior(wheels, duration_s);
  std::vector<Match> matches = {
      Track(before * prior.hypotheses().front().motion, prior.hypotheses().front())};
  if (!prior.GuessesAgree() || !IsConvincing(matches.front(), prior)) {
    for (std::size_t k = 1; k < prior.hypotheses().size(); ++k) {
      matches.push_back(Track(before * prior.hypotheses()[k].motion, prior.hypotheses()[k]));
    }
    Rank(prior, &matches);
    for (const Window& window : kWindows) {
      if (IsConvincing(matches.front(), prior)) break;
      result.searched = true;
      for (const Match& match : Search(prior, window.linear_m, window.angular_rad)) {
        matches.push_back(match);
      }
      Rank(prior, &matches);
    }
  }
  const Match& best = matches.front();
  Learn(best, prior, wheels, duration_s);
  odom_T_robot_ = best.odom_T_robot;
  result.motion = Between(before, odom_T_robot_);
  result.wheels_rejected =
      prior.hypotheses().front().SquaredDistance(result.motion) > kAgrees;
  result.wheels_silent = wheels.fault == OdometryFault::kUnchanged &&
                         prior.hypotheses().size() == 1 && Moves(result.motion);
  const double fit_nats = Nats(best, best.evidence.unknown);
  result.matched = fit_nats > -kGarbage_nats;
  double sum = 0.0;
  for (const Match& match : matches) {
    const double nats = match.log_posterior - best.log_posterior;
    if (matches.size() == 1 || nats < -kAmbiguous_nats) continue;
    result.alternatives.push_back({Between(before, match.odom_T_robot), std::exp(nats)});
    sum += std::exp(nats);
  }
  if (result.alternatives.size() == 1) result.alternatives.clear();
  for (auto& alternative : result.alternatives) alternative.probability /= sum;

  // A map must not hold both sides of a step that may be wrong.
  if (!result.alternatives.empty()) map_.Clear();
  const SE2 since_entered = Between(odom_T_entered_, odom_T_robot_);
  if (map_.empty() || since_entered.translation().norm() > options_.enter_m ||
      std::abs(since_entered.theta) > options_.enter_rad) {
    odom_T_entered_ = odom_T_robot_;
    map_.Enter(scan, odom_T_robot_);
  }
  return result;
}

// Loggers may stamp scans when they write them, several at once: times are taken with a pinch of
// salt.
double ScanOdometry::DurationRatio(double duration_s) const {
  return std::clamp(duration_s / usual_duration_s_, 1.0 / kMaxRatio, kMaxRatio);
}

MotionPrior ScanOdometry::MakePrior(const sensor::OdometryCheck::Step& wheels,
                                    double duration_s) const {
  // Wheels that have never moved may not be there at all.
  const bool silent = wheels.fault == OdometryFault::kUnchanged &&
                      (silent_scans_ >= kSilentScans || !wheels_ever_moved_);
  const bool trust = !silent && (wheels.fault == OdometryFault::kNone ||
                                 wheels.fault == OdometryFault::kUnchanged);
  const SE2 going_on = backend::Exp(DurationRatio(duration_s) * usual_motion_);
  std::optional<WheelMotion> guess;
  if (trust) {
    guess = {wheels.motion, std::sqrt(std::max(wheel_error_, 1.0)),
             std::clamp(wheels_wrong_, kMinWheelsWrong, kMaxWheelsWrong)};
  }
  return {options_.prior, guess, going_on, std::max(duration_s, usual_duration_s_)};
}

// Fuses the scan with the guess.
ScanOdometry::Match ScanOdometry::Track(const SE2& initial,
                                        const MotionHypothesis& hypothesis) const {
  Match match;
  match.odom_T_robot =
      matcher_.Align(map_.grid(), points_, initial, hypothesis.Information()).world_T_robot;
  scan_matching::EndpointModel model(options_.endpoint, &map_.grid(), &points_);
  match.evidence = model.Evaluate(match.odom_T_robot);
  return match;
}

// The best and the second best match of a window around where the robot would be at the same
// velocity.
std::vector<ScanOdometry::Match> ScanOdometry::Search(const MotionPrior& prior, double window_m,
                                                      double window_rad) {
  std::vector<Eigen::Vector2d> positions;
  double reach_m = 1.0;
  for (const scan_matching::ScanPoint& point : points_) {
    positions.emplace_back(point.x_m, point.y_m);
    reach_m = std::max(reach_m, std::hypot(point.x_m, point.y_m));
  }
  scan_matching::CorrelativeMatcher::Options search;
  search.min_score = 0.2;
  search.second_floor = 0.8;
  search.peak_separation_m = 0.2;
  search.with_covariance = false;
  const SE2 centre = odom_T_robot_ * prior.hypotheses().back().motion;
  const CorrelativeMatch found =
      map_.Search(search, odom_T_robot_, reach_m + 1.5)
          .Match(positions, centre,
                 {std::min(window_m, prior.reach_m()), std::min(window_rad, prior.reach_rad())});
  std::vector<Match> matches;
  if (!found.found) return matches;
  const MotionHypothesis weak{.motion = {}, .sigma_m = 0.1, .sigma_rad = 0.1};
  matches.push_back(Track(found.map_T_scan, weak));
  if (found.second_map_T_scan != found.map_T_scan) {
    matches.push_back(Track(found.second_map_T_scan, weak));
  }
  return matches;
}

// Whether the match fits about as well as usual, and agrees with all guesses about the motion.
bool ScanOdometry::IsConvincing(const Match& match, const MotionPrior& prior) const {
  const double missing =
      match.evidence.known() * options_.doubt_below * usual_fit_ - match.evidence.explained;
  if (missing > kFewBeams * usual_fit_) return false;
  const SE2 motion = Between(odom_T_robot_, match.odom_T_robot);
  return prior.hypotheses().front().SquaredDistance(motion) < kAgrees ||
         prior.hypotheses().back().SquaredDistance(motion) < kAgrees;
}

// A beam says so many nats for a pose as it fits better than usual; in unseen space, none.
double ScanOdometry::Nats(const Match& match, double least_unknown) const {
  const scan_matching::Evidence& e = match.evidence;
  const double free_unknown = least_unknown + kFreeUnknown * static_cast<double>(points_.size());
  const double unexpected = std::max(e.unknown - free_unknown, 0.0);
  return kNatsPerBeam * (e.explained - usual_fit_ * (e.known() + unexpected));
}

// Sorts by the posterior and leaves out what is the same.
void ScanOdometry::Rank(const MotionPrior& prior, std::vector<Match>* matches) const {
  double least_unknown = 1e9;
  for (const Match& match : *matches) {
    least_unknown = std::min(least_unknown, match.evidence.unknown);
  }
  for (Match& match : *matches) {
    match.log_posterior = std::max(Nats(match, least_unknown), -kGarbage_nats) +
                          prior.LogDensity(Between(odom_T_robot_, match.odom_T_robot));
  }
  std::stable_sort(matches->begin(), matches->end(), [](const Match& a, const Match& b) {
    return a.log_posterior > b.log_posterior;
  });
  std::vector<Match> different;
  for (const Match& match : *matches) {
    if (std::none_of(different.begin(), different.end(), [&](const Match& other) {
          return IsSame(match.odom_T_robot, other.odom_T_robot);
        })) {
      different.push_back(match);
    }
  }
  *matches = std::move(different);
}

void ScanOdometry::Learn(const Match& match, const MotionPrior& prior,
                         const sensor::OdometryCheck::Step& wheels, double duration_s) {
  if (match.evidence.known() > 0.0) {
    usual_fit_ += kForgetting * (match.evidence.Fit() - usual_fit_);
    usual_fit_ = std::max(usual_fit_, kMinUsualFit);
  }
  const SE2 motion = Between(odom_T_robot_, match.odom_T_robot);
  const double scale = Nats(match, match.evidence.unknown) > -kGarbage_nats ? 1.0 : kSlowDown;
  usual_motion_ += kVelocityGain * (scale * backend::Log(motion) / DurationRatio(duration_s) -
                                    usual_motion_);
  const MotionHypothesis& first = prior.hypotheses().front();
  const bool agrees = first.SquaredDistance(motion) < kAgrees;
  if (prior.hypotheses().size() > 1) {
    // Three dimensions; what is no normal noise counts for the other mean.
    const double error = std::max(wheel_error_, 1.0) * first.SquaredDistance(motion) / 3.0;
    wheel_error_ += kForgetting * (std::min(error, kMaxWheelError) - wheel_error_);
    wheels_wrong_ += kForgetting * ((agrees ? 0.0 : 1.0) - wheels_wrong_);
  }
  if (wheels.fault == OdometryFault::kNone) {
    wheels_ever_moved_ = true;
    silent_scans_ = 0;
  } else if (wheels.fault == OdometryFault::kUnchanged && silent_scans_ < kSilentScans) {
    silent_scans_ = agrees ? 0 : silent_scans_ + 1;
  }
}

}  // namespace gmapping_spa::frontend
