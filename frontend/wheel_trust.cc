// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/wheel_trust.h"

#include <algorithm>
#include <cmath>

namespace gmapping_spa::frontend {

using backend::SE2;
using sensor::OdometryFault;

namespace {

constexpr double kForgetting = 0.05;  // a scan's share in the running means
constexpr double kKeepOwed = 0.9;     // part of what is owed that the next scan still counts
constexpr double kMinWrong = 0.01, kMaxWrong = 0.5;
constexpr double kMaxError = 100.0;   // of one scan, so that a slip does not count for all
constexpr double kContradicts = 9.0;  // squared standard deviations
constexpr int kSilentScans = 3;
constexpr double kTold_m = 1e-5;  // more than rounding
// Wheels that slam on the brakes slide; readings that freeze stop at once.
constexpr double kMostBraking_m_s2 = 4.0;
constexpr double kSeenMotion_m = 0.03;  // more than what scan matching is off by
constexpr double kTurns_rad = 0.02;     // more than what scans and wheels are off by

constexpr int kBlockScans = 20;       // in which the wheels moved
constexpr double kBlockShare = 0.05;  // least share of a block in the running means
constexpr double kMaxBlockError = 10.0;
// The mean is of few blocks: the variance may be this many times as large.
constexpr double kErrorToVariance = 2.0;
constexpr double kMostGain = 100.0;  // ten times surer than expected, no more

// More than what wheels that stand still read.
bool Moves(const SE2& step) {
  return step.translation().norm() > 1e-3 || std::abs(step.theta) > 1e-3;
}

// Whether a robot that went on like that can not stand still now.
bool StopsTooSoon(const SE2& same_velocity, double duration_s) {
  const double way_m = same_velocity.translation().norm();
  return way_m > kSeenMotion_m && way_m > kMostBraking_m_s2 * duration_s * duration_s;
}

double Gain(double block_error) {
  return 1.0 / std::clamp(kErrorToVariance * block_error, 1.0 / kMostGain, 1.0);
}

}  // namespace

std::optional<WheelMotion> WheelTrust::Guess(const sensor::OdometryCheck::Step& wheels,
                                             const SE2& same_velocity, double duration_s) {
  raw_step_ = wheels.motion;
  step_ = calibration_.Corrected(raw_step_);
  unchanged_ = wheels.fault == OdometryFault::kUnchanged;
  if (wheels.fault == OdometryFault::kNone) {
    ever_moved_ = true;
    if (raw_step_.translation().norm() > kTold_m) ever_told_way_ = true;
    contradicted_while_unchanged_ = 0;
  }
  silent_ = unchanged_ && (!ever_moved_ || contradicted_while_unchanged_ >= kSilentScans ||
                           StopsTooSoon(same_velocity, duration_s));
  if (silent_ || (wheels.fault != OdometryFault::kNone && !unchanged_)) return std::nullopt;
  if (tells_turns_only()) step_ = {same_velocity.x, same_velocity.y, step_.theta};
  const StepError& error = late() ? late_error_ : step_error_;
  return WheelMotion{.motion = late() ? Owed() : step_,
                     .sigma_factor_m = std::sqrt(std::max(error.m, 1.0)),
                     .sigma_factor_rad = std::sqrt(std::max(error.rad, 1.0)),
                     .wrong = std::clamp(wrong_, kMinWrong, kMaxWrong),
                     .tells_way = !tells_turns_only(),
                     .gain_m = tells_turns_only() ? 1.0 : Gain(block_error_m_),
                     .gain_rad = Gain(block_error_rad_)};
}

void WheelTrust::StepError::Learn(const MotionHypothesis& expected, const SE2& motion) {
  const SE2 off = Between(expected.motion, motion);
  const auto learn = [](double squared_sigmas, double* mean) {
    *mean += kForgetting * (std::min(squared_sigmas, kMaxError) - *mean);
  };
  learn(off.translation().squaredNorm() / (2.0 * expected.sigma_m * expected.sigma_m), &m);
  learn(off.theta * off.theta / (expected.sigma_rad * expected.sigma_rad), &rad);
}

void WheelTrust::Learn(const SE2& motion, const MotionHypothesis& guess, bool tells_position) {
  // The deviations expected of the wheels, without the factor of mistrust; three dimensions.
  MotionHypothesis plain = guess;
  const StepError& error = late() ? late_error_ : step_error_;
  plain.sigma_m /= std::sqrt(std::max(error.m, 1.0));
  plain.sigma_rad /= std::sqrt(std::max(error.rad, 1.0));
  plain.motion = step_;
  LearnBlock(motion, plain, tells_position);
  step_error_.Learn(plain, motion);
  plain.motion = Owed();
  late_error_.Learn(plain, motion);
  const bool contradicted = guess.SquaredDistance(motion) > kContradicts;
  wrong_ += kForgetting * ((contradicted ? 1.0 : 0.0) - wrong_);
  if (unchanged_) {
    contradicted_while_unchanged_ = contradicted ? contradicted_while_unchanged_ + 1 : 0;
  }
  const double turn_rad = std::min(std::abs(raw_step_.theta), std::abs(motion.theta));
  if (turn_rad > kTurns_rad) {
    turned_rad_ += turn_rad;
    opposite_rad_ += raw_step_.theta * motion.theta < 0.0 ? turn_rad : 0.0;
  }
  Learn(motion);
}

// `plain`: the wheels' step with the deviations expected of it. Where the scan may not tell the
// way, it is no judge of the wheels' way: a corridor that is shortened would make good wheels bad.
void WheelTrust::LearnBlock(const SE2& motion, const MotionHypothesis& plain, bool tells_position) {
  block_wheels_ = block_wheels_ * plain.motion;
  block_motion_ =
      block_motion_ * (tells_position ? motion : SE2{plain.motion.x, plain.motion.y, motion.theta});
  calibration_.Add(raw_step_, motion);
  if (!Moves(plain.motion)) return;
  if (tells_position) block_variance_m2_ += plain.sigma_m * plain.sigma_m;
  block_variance_rad2_ += plain.sigma_rad * plain.sigma_rad;
  if (++block_scans_ < kBlockScans) return;
  const SE2 off = Between(block_wheels_, block_motion_);
  const double share = std::max(kBlockShare, 2.0 / (++blocks_ + 2));
  const auto learn = [share](double error, double* mean) {
    *mean += share * (std::min(error, kMaxBlockError) - *mean);
  };
  if (block_variance_m2_ > 0.0) {
    learn(off.translation().squaredNorm() / (2.0 * block_variance_m2_), &block_error_m_);
  }
  learn(off.theta * off.theta / block_variance_rad2_, &block_error_rad_);
  calibration_.Learn(block_variance_rad2_);
  block_wheels_ = block_motion_ = {};
  block_variance_m2_ = block_variance_rad2_ = 0.0;
  block_scans_ = 0;
}

void WheelTrust::Learn(const SE2& motion) {
  owed_ = backend::Exp(kKeepOwed * backend::Log(Inverse(motion) * Owed()));
}

}  // namespace gmapping_spa::frontend
