// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/lidar_odometry.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "frontend/scan_density.h"

namespace gmapping_spa::frontend {

using backend::SE2;
using sensor::OdometryFault;

namespace {

constexpr double kForgetting = 0.05;  // a scan's share in the running mean of the fit
constexpr double kMinUsualFit = 0.3;

// Time between scans, s: stamps jitter, and are lost for long.
constexpr double kMinDuration_s = 0.02;
constexpr double kMaxDuration_s = 1.0;
// Usual times between scans, after which nobody knows what happened meanwhile.
constexpr double kGap = 3.0;

// Nats by which a beam of full weight that fits tells a pose from one where it does not.
constexpr double kNatsPerBeam = 1.0;
// A scan that fits nowhere (a covered laser, a crowd) does not constrain the motion, at this price
// and that of its beams that pass through walls, which nothing covers.
constexpr double kGarbage_nats = 30.0;
// The same of a scan after such a one, of whose misfits at most this part see through walls.
constexpr double kStillGarbage_nats = 5.0;
constexpr double kCovered = 0.3;

// Part of the beams that may end in unseen space more than at another pose before it counts.
constexpr double kFreeUnknown = 0.1;

// Alternatives that are less likely than the best by this factor, e^-nats, are no alternatives.
constexpr double kAmbiguous_nats = 3.0;
// Probability from which on the likeliest of several alternatives is taken to be the right one.
constexpr double kDecided = 0.6;
// Matches nearer to each other than this are the same.
constexpr double kSame_m = 0.1;
constexpr double kSame_rad = 0.05;

// A scan of which more than this part ends in unseen space may be anywhere, if that is so much more
// than usual: a new map knows little.
constexpr double kMostUnknown = 0.6;
constexpr double kMoreUnknown = 0.3;

// Of beams in doubt: fewer that do not fit prove nothing.
constexpr double kFewBeams = 4.0;

// As far from where it began, a robot has driven and not only turned on the spot.
constexpr double kSomeWay_m = 0.5;

constexpr int kScansToKnowVelocity = 3;

// Steps since the pose was sure of which the errors add up; more are as good as lost.
constexpr int kMostSteps = 10;

// More than what scan matching is off by.
bool Moves(const SE2& motion) {
  return motion.translation().norm() > 0.02 || std::abs(motion.theta) > 0.01;
}

bool IsSame(const SE2& a, const SE2& b) {
  const SE2 off = Between(a, b);
  return off.translation().norm() < kSame_m && std::abs(off.theta) < kSame_rad;
}

}  // namespace

LidarOdometry::LidarOdometry(const Options& options)
    : options_(options),
      gauss_newton_(options.gauss_newton),
      map_(
          [&options] {
            map::OccupancyGrid::Options grid = options.grid;
            grid.occupied_threshold = options.occupied_threshold;
            return grid;
          }(),
          options.map_scans),
      sweep_(options.grid, options.gauss_newton, options.sweep_duration_s) {}

ScanMotion LidarOdometry::MatchScan(const sensor::LaserScan& scan,
                                    const sensor::OdometryCheck::Step& wheels) {
  ++new_piece_scans_;
  sweep_.Tell(scan.sweep_s);
  if (map_.empty()) {
    map_.Insert(scan, odom_T_robot_);
    stamp_s_ = scan.stamp_s;
    return {};
  }
  const bool is_gap = scan.stamp_s - stamp_s_ > kGap * usual_duration_s_;
  const double duration_s = std::clamp(scan.stamp_s - stamp_s_, kMinDuration_s, kMaxDuration_s);
  stamp_s_ = scan.stamp_s;
  usual_duration_s_ += kForgetting * (duration_s - usual_duration_s_);
  const SE2 before = odom_T_robot_;
  ScanMotion result;
  if (wheels.fault == OdometryFault::kRepeatedScan) {  // the scan is of no use
    odom_T_robot_ = before * wheels.motion;
    result.motion = wheels.motion;
    result.matched = false;
    if (new_piece_) new_piece_->MatchScan(scan, wheels);
    return result;
  }

  const std::optional<WheelMotion> guess =
      wheel_trust_.Guess(wheels, SameVelocity(duration_s), std::max(duration_s, usual_duration_s_));
  const MotionPrior prior = MakePrior(guess, duration_s);
  if (is_gap) {
    drove_unseen_ =
        guess && guess->tells_way && guess->motion.translation().norm() > options_.insert_m;
  }
  points_ = scan_matching::MakeScanPoints(
      Deskewed(scan, VelocityOf(prior.hypotheses().front().motion, duration_s)));
  std::vector<Match> matches = {
      Track(before * prior.hypotheses().front().motion, prior.hypotheses().front())};
  // At first the velocity is not known, and a map of one scan says that nothing has moved.
  const bool guesses_agree = scans_ < kScansToKnowVelocity || prior.GuessesAgree();
  const double density = ScanDensity(scan);
  const bool is_dense = density == 1.0;  // few beams fit in too many places by chance
  const bool may_be_next_peak =
      scans_ >= kScansToKnowVelocity && is_dense && MayLeadToNextPeak(prior, guess.has_value());
  if (may_be_next_peak || !guesses_agree || !IsConvincing(matches.front(), prior)) {
    for (std::size_t k = 1; k < prior.hypotheses().size(); ++k) {
      matches.push_back(Track(before * prior.hypotheses()[k].motion, prior.hypotheses()[k]));
    }
    for (Match& match : matches) CountBehindWalls(&match);
    // After a gap the robot sees much that is new at the right place as well: no evidence against
    // it.
    unseen_ahead_ = drove_unseen_ ? matches.front().evidence.unknown : 0.0;
    Rank(prior, &matches);
    result.searched = SearchUntilOneConvinces(prior, may_be_next_peak, &matches);
  }
  const Match& best = matches.front();
  unsure_scans_ = IsConvincing(best, prior) ? 0 : unsure_scans_ + 1;
  if (IsLost(best) || IsJump(best, prior, is_gap)) {
    drove_unseen_ = false;
    result = GoOnLost(best, scan, wheels, guess);
    result.velocity = VelocityOf(result.motion, duration_s);
    return result;
  }
  new_piece_.reset();
  doubtful_scans_ = IsDoubtful(best) ? doubtful_scans_ + 1 : 0;
  result.matched = doubtful_scans_ == 0 || doubtful_scans_ > options_.doubtful_scans;
  Learn(best, duration_s);
  odom_T_robot_ = best.odom_T_robot;
  result.motion = Between(before, odom_T_robot_);
  result.velocity = VelocityOf(result.motion, duration_s);
  // A way that the wheels do not tell can not be wrong.
  const SE2& guessed = prior.hypotheses().front().motion;
  const SE2 told =
      guess && !guess->tells_way ? SE2{guessed.x, guessed.y, result.motion.theta} : result.motion;
  result.wheels_rejected = !prior.hypotheses().front().AgreesWith(told);
  if (guess && !result.wheels_rejected) {
    result.noise = 1.0 / std::sqrt(std::min(guess->gain_m, guess->gain_rad));
  }
  if (guess) {
    wheel_trust_.Learn(result.motion, prior.hypotheses().front(), best.tells_position);
  } else {
    wheel_trust_.Learn(result.motion);
  }
  result.wheels_silent = wheel_trust_.silent() && Moves(result.motion);
  result.wheels_turn_only =
      wheel_trust_.tells_turns_only() && odom_T_robot_.translation().norm() > kSomeWay_m;
  const bool wheels_tell = guess && guess->tells_way && !result.wheels_rejected;
  result.unobserved = !wheels_tell && !points_.empty() && !best.tells_position;
  result.wheels_late = guess && wheel_trust_.late();
  result.wheels_mirrored = wheel_trust_.mirrored();
  double sum = 0.0;
  for (const Match& match : matches) {
    const double nats = match.log_posterior - best.log_posterior;
    if (matches.size() == 1 || nats < -kAmbiguous_nats) continue;
    result.alternatives.push_back({Between(before, match.odom_T_robot), std::exp(nats)});
    sum += std::exp(nats);
  }
  if (result.alternatives.size() == 1) result.alternatives.clear();
  for (auto& alternative : result.alternatives) alternative.probability /= sum;

  // What may be wrong is not entered, and the map of before decides with the next scans. Where no
  // place is likelier, it is forgotten: it must not hold both sides of a step that may be wrong.
  // One scan of few beams is no map.
  const bool is_ambiguous = !result.alternatives.empty();
  if (is_ambiguous && result.alternatives.front().probability < kDecided && is_dense) {
    map_.Clear();
    usual_unknown_ = 1.0;
  }
  if (result.matched && !is_ambiguous) sweep_.Learn(scan, odom_T_robot_, result.velocity);
  const SE2 since_inserted = Between(odom_T_inserted_, odom_T_robot_);
  const bool moved_on = since_inserted.translation().norm() > density * options_.insert_m ||
                        std::abs(since_inserted.theta) > density * options_.insert_rad;
  if (moved_on) fits_along_ = FitsAlong(best, result.motion);  // as often as it may change
  result.unchecked = wheels_tell && fits_along_;
  if (map_.empty() || (moved_on && result.matched && !is_ambiguous)) {
    odom_T_inserted_ = odom_T_robot_;
    drove_unseen_ = false;
    map_.Insert(Deskewed(scan, result.velocity), odom_T_robot_);
  }
  return result;
}

MotionPrior LidarOdometry::MakePrior(const std::optional<WheelMotion>& wheels,
                                     double duration_s) const {
  return {options_.prior, wheels, SameVelocity(duration_s), std::max(duration_s, usual_duration_s_),
          std::min(1 + unsure_scans_, kMostSteps)};
}

// Fuses the scan with the guess. Wheels tell the way where the scan may not: door frames and rough
// walls would shorten a corridor all along.
LidarOdometry::Match LidarOdometry::Track(const SE2& initial,
                                          const MotionHypothesis& hypothesis) const {
  const auto align = [&](scan_matching::GaussNewton::Trust trust) {
    return gauss_newton_.Align(map_.grid(), points_, initial, hypothesis.Information(), trust)
        .world_T_robot;
  };
  Match match;
  match.odom_T_robot = align(scan_matching::GaussNewton::Trust::kUsual);
  match.tells_position = gauss_newton_.TellsPosition(map_.grid(), points_, match.odom_T_robot);
  if (hypothesis.way_is_measured && !match.tells_position) {
    match.odom_T_robot = align(scan_matching::GaussNewton::Trust::kLeast);
  }
  scan_matching::EndpointModel model(options_.endpoint, &map_.grid(), &points_);
  match.evidence = model.Evaluate(match.odom_T_robot);
  return match;
}

// Whether the match fits about as well as usual in what has been seen before, and agrees with a
// guess about the motion; after a gap with the first: the velocity of before says next to nothing.
bool LidarOdometry::IsConvincing(const Match& match, const MotionPrior& prior) const {
  const double missing =
      match.evidence.known() * options_.doubt_below * usual_fit_ - match.evidence.explained;
  if (missing > kFewBeams * usual_fit_) return false;
  const double may_be_unknown = std::max(kMostUnknown, usual_unknown_ + kMoreUnknown);
  if (match.evidence.unknown > may_be_unknown * match.evidence.all()) return false;
  const SE2 motion = Between(odom_T_robot_, match.odom_T_robot);
  return prior.hypotheses().front().AgreesWith(motion) ||
         (!drove_unseen_ && prior.hypotheses().back().AgreesWith(motion));
}

// A beam says so many nats for a pose as it fits better than usual; in unseen space, none.
double LidarOdometry::Nats(const Match& match, double least_unknown) const {
  const scan_matching::Evidence& e = match.evidence;
  const double free_unknown =
      std::max(least_unknown, usual_unknown_ * e.all()) + kFreeUnknown * e.all();
  const double unexpected = std::max(e.unknown - free_unknown, 0.0);
  return kNatsPerBeam * (e.explained - usual_fit_ * (e.known() + unexpected));
}

// Sorts by the posterior and leaves out what is the same.
void LidarOdometry::Rank(const MotionPrior& prior, std::vector<Match>* matches) const {
  double least_unknown = 1e9;
  for (const Match& match : *matches) {
    least_unknown = std::min(least_unknown, match.evidence.unknown);
  }
  least_unknown = std::max(least_unknown, unseen_ahead_);
  for (Match& match : *matches) {
    // What covers a laser stays for a while, and lets no beam see through walls.
    const bool is_covered =
        new_piece_ && match.seen_through <= kCovered * match.evidence.contradicted;
    const double garbage_nats = (is_covered ? kStillGarbage_nats : kGarbage_nats) +
                                kNatsPerBeam * usual_fit_ * match.seen_through;
    match.log_posterior = std::max(Nats(match, least_unknown), -garbage_nats) +
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

void LidarOdometry::Learn(const Match& match, double duration_s) {
  ++scans_;
  if (match.evidence.known() > 0.0) {
    usual_fit_ += kForgetting * (match.evidence.Fit() - usual_fit_);
    usual_fit_ = std::max(usual_fit_, kMinUsualFit);
  }
  if (match.evidence.all() > 0.0) {
    const double unknown = match.evidence.unknown / match.evidence.all();
    usual_unknown_ += kForgetting * (unknown - usual_unknown_);
  }
  LearnVelocity(match, duration_s);
}

}  // namespace gmapping_spa::frontend
