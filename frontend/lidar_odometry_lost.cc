// SPDX-License-Identifier: BSD-3-Clause
// What a robot does whose scans fit nothing that it has seen before.
#include <memory>
#include <optional>
#include <utility>

#include "frontend/lidar_odometry.h"
#include "frontend/scan_matching/seen_through.h"

namespace gmapping_spa::frontend {

using backend::SE2;

namespace {

// Parts of the usual fit.
constexpr double kLostBelow = 0.5;
constexpr double kBackAbove = 0.75;
constexpr double kJumpAbove = 0.65;
constexpr double kBackByJumpAbove = 0.9;

// Of full weight: fewer that do not fit are no proof that the robot is elsewhere, or are no
// evidence.
constexpr double kBeamsToBeLost = 8.0;
constexpr double kBeamsInDoubt = 2.0;

// Of beams that pass through walls, as a part of those that contradict the pose: with fewer
// something may hide the walls.
constexpr double kElsewhere = 0.5;
// Of them in all scans since the robot was lost: a few scans of few beams prove little.
constexpr double kBeamsToBeElsewhere = 100.0;

}  // namespace

// A place that changes, or a bad scan, explains less than usual; another place explains next to
// nothing. A lost robot is taken to be back no sooner than a scan fits nearly as well as usual.
bool LidarOdometry::IsLost(const Match& match) const {
  const scan_matching::Evidence& e = match.evidence;
  if (new_piece_) return e.known() < kBeamsToBeLost || e.Fit() < kBackAbove * usual_fit_;
  return usual_fit_ * e.known() - e.explained > kBeamsToBeLost && e.Fit() < kLostBelow * usual_fit_;
}

// Fits not well where nothing has led the robot: it may be elsewhere, in a place alike. After a
// gap, or when it was lost, nobody knows that it goes on as before.
bool LidarOdometry::IsJump(const Match& match, const MotionPrior& prior, bool is_gap) const {
  const SE2 motion = Between(odom_T_robot_, match.odom_T_robot);
  const scan_matching::Evidence& e = match.evidence;
  const double well = new_piece_ ? kBackByJumpAbove : kJumpAbove;
  return e.known() > kBeamsToBeLost && e.Fit() < well * usual_fit_ &&
         !prior.hypotheses().front().AgreesWith(motion) &&
         (is_gap || new_piece_ || !prior.hypotheses().back().AgreesWith(motion));
}

// Fits badly by too few beams for the robot to be lost. Whether the scan is where it seems to be,
// the next ones show; until then it is not to be a part of the map that they are matched with.
bool LidarOdometry::IsDoubtful(const Match& match) const {
  const scan_matching::Evidence& e = match.evidence;
  return usual_fit_ * e.known() - e.explained > kBeamsInDoubt && e.Fit() < kLostBelow * usual_fit_;
}

// The map stays as it is, for the case that the robot is seen to be where the wheels say.
ScanMotion LidarOdometry::GoOnLost(const Match& best, const sensor::LaserScan& scan,
                                   const sensor::OdometryCheck::Step& wheels,
                                   const std::optional<WheelMotion>& guess) {
  ScanMotion result;
  result.matched = false;
  if (guess) result.motion = guess->motion;
  wheels_told_all_ = guess.has_value() && (wheels_told_all_ || !new_piece_);
  const ScanMotion found = new_piece_ ? new_piece_->MatchScan(scan, wheels) : result;
  if (found.matched) {
    // A covered laser fits itself however the robot moves: the wheels go first.
    if (!guess) result.motion = found.motion;
  } else {
    new_piece_ = std::make_unique<LidarOdometry>(options_);
    new_piece_->scans_ = scans_;
    new_piece_->usual_motion_ = usual_motion_;
    new_piece_->usual_duration_s_ = usual_duration_s_;
    new_piece_->usual_fit_ = usual_fit_;
    new_piece_->wheel_trust_ = wheel_trust_;
    new_piece_->sweep_ = sweep_;
    new_piece_->sweep_.BeginFrame();
    new_piece_->MatchScan(scan, wheels);
    new_piece_begin_s_ = scan.stamp_s;
    new_piece_scans_ = 1;
    seen_through_ = contradicted_ = 0.0;
  }
  seen_through_ += scan_matching::CountSeenThrough(map_.grid(), points_, best.odom_T_robot).all;
  contradicted_ += best.evidence.contradicted;
  const bool is_elsewhere =
      seen_through_ > kElsewhere * contradicted_ && seen_through_ > kBeamsToBeElsewhere;
  if (new_piece_scans_ >= options_.new_piece_scans &&
      scan.stamp_s - new_piece_begin_s_ >=
          (is_elsewhere ? options_.new_piece_s : options_.new_piece_if_hidden_s)) {
    result.matched = true;
    result.new_piece_scans = new_piece_scans_;
    result.wheels_told_way_to_piece = wheels_told_all_;
    const std::unique_ptr<LidarOdometry> piece = std::move(new_piece_);
    *this = std::move(*piece);
    return result;
  }
  odom_T_robot_ = odom_T_robot_ * result.motion;
  wheel_trust_.Learn(result.motion);
  return result;
}

}  // namespace gmapping_spa::frontend
