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
constexpr double kTurns_rad = 0.02;  // more than what scans and wheels are off by

}  // namespace

std::optional<WheelMotion> WheelTrust::Guess(const sensor::OdometryCheck::Step& wheels) {
  step_ = wheels.motion;
  unchanged_ = wheels.fault == OdometryFault::kUnchanged;
  if (wheels.fault == OdometryFault::kNone) {
    ever_moved_ = true;
    contradicted_while_unchanged_ = 0;
  }
  silent_ = unchanged_ && (!ever_moved_ || contradicted_while_unchanged_ >= kSilentScans);
  if (silent_ || (wheels.fault != OdometryFault::kNone && !unchanged_)) return std::nullopt;
  const double error = std::max(late() ? late_error_ : step_error_, 1.0);
  return WheelMotion{late() ? Owed() : step_, std::sqrt(error),
                     std::clamp(wrong_, kMinWrong, kMaxWrong)};
}

void WheelTrust::Learn(const SE2& motion, const MotionHypothesis& guess) {
  // The deviations expected of the wheels, without the factor of mistrust; three dimensions.
  MotionHypothesis plain = guess;
  const double factor = std::sqrt(std::max(late() ? late_error_ : step_error_, 1.0));
  plain.sigma_m /= factor;
  plain.sigma_rad /= factor;
  plain.motion = step_;
  const double step_error = std::min(plain.SquaredDistance(motion) / 3.0, kMaxError);
  plain.motion = Owed();
  const double late_error = std::min(plain.SquaredDistance(motion) / 3.0, kMaxError);
  const bool contradicted = guess.SquaredDistance(motion) > kContradicts;
  step_error_ += kForgetting * (step_error - step_error_);
  late_error_ += kForgetting * (late_error - late_error_);
  wrong_ += kForgetting * ((contradicted ? 1.0 : 0.0) - wrong_);
  if (unchanged_) {
    contradicted_while_unchanged_ = contradicted ? contradicted_while_unchanged_ + 1 : 0;
  }
  const double turn_rad = std::min(std::abs(step_.theta), std::abs(motion.theta));
  if (turn_rad > kTurns_rad) {
    turned_rad_ += turn_rad;
    opposite_rad_ += step_.theta * motion.theta < 0.0 ? turn_rad : 0.0;
  }
  Learn(motion);
}

void WheelTrust::Learn(const SE2& motion) {
  owed_ = backend::Exp(kKeepOwed * backend::Log(Inverse(motion) * Owed()));
}

}  // namespace gmapping_spa::frontend
