// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/motion_prior.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gmapping_spa::frontend {

using backend::SE2;

namespace {

// Error of the wheels' steps lately, as a factor on the standard deviation that is expected.
constexpr double kAboutAsExpected = 1.5;

}  // namespace

Eigen::Matrix3d MotionHypothesis::Information() const {
  const Eigen::Array3d gain(gain_m, gain_m, gain_rad);
  const Eigen::Array3d sigma(sigma_m, sigma_m, sigma_rad);
  return (gain / sigma.square()).matrix().asDiagonal();
}

double MotionHypothesis::SquaredDistance(const SE2& other) const {
  const SE2 off = Between(motion, other);
  return (off.x * off.x + off.y * off.y) / (sigma_m * sigma_m) +
         off.theta * off.theta / (sigma_rad * sigma_rad);
}

bool MotionHypothesis::AgreesWith(const SE2& other) const {
  constexpr double kNineSigmas = 9.0;  // squared
  return SquaredDistance(other) < kNineSigmas;
}

double MotionHypothesis::LogDensity(const SE2& other) const {
  return std::log(weight) - 0.5 * SquaredDistance(other) - 1.5 * std::log(2.0 * std::numbers::pi) -
         std::log(sigma_m * sigma_m * sigma_rad);
}

MotionPrior::MotionPrior(const Options& options, const std::optional<WheelMotion>& wheels,
                         const SE2& same_velocity, double duration_s, int steps) {
  const double square_s2 = duration_s * duration_s;
  const double widening = std::sqrt(steps);
  const double wheels_right = wheels ? std::pow(1.0 - wheels->wrong, steps) : 0.0;
  const MotionHypothesis going_on{
      .motion = same_velocity,
      .sigma_m = widening * (options.velocity_floor_m + options.acceleration_m_s2 * square_s2),
      .sigma_rad = std::min(
          widening * (options.velocity_floor_rad + options.angular_acceleration_rad_s2 * square_s2),
          std::numbers::pi),
      .weight = 1.0 - wheels_right};
  if (wheels) {
    const double linear_m = wheels->motion.translation().norm();
    const double angular_rad = std::abs(wheels->motion.theta);
    const double sigma_m = wheels->tells_way
                               ? widening * (options.floor_m + options.m_per_m * linear_m +
                                             options.m_per_rad * angular_rad)
                               : going_on.sigma_m;
    hypotheses_.push_back(
        {.motion = wheels->motion,
         .sigma_m = wheels->sigma_factor_m * sigma_m,
         .sigma_rad =
             widening * wheels->sigma_factor_rad *
             (options.floor_rad + options.rad_per_m * linear_m + options.rad_per_rad * angular_rad),
         .weight = wheels_right,
         .way_is_measured = wheels->tells_way && wheels->sigma_factor_m < kAboutAsExpected,
         .gain_m = wheels->gain_m,
         .gain_rad = wheels->gain_rad});
  }
  hypotheses_.push_back(going_on);
  reach_m_ = std::max(options.max_speed_m_s * steps * duration_s, going_on.sigma_m);
  reach_rad_ = std::min(std::max(options.max_turn_rad_s * steps * duration_s, going_on.sigma_rad),
                        std::numbers::pi);
  anything_density_ = options.anything * steps / (4.0 * reach_m_ * reach_m_ * 2.0 * reach_rad_);
}

bool MotionPrior::GuessesAgree() const {
  return hypotheses_.back().AgreesWith(hypotheses_.front().motion);
}

double MotionPrior::LogDensity(const SE2& motion) const {
  double density = anything_density_;
  for (const MotionHypothesis& hypothesis : hypotheses_) {
    density += std::exp(hypothesis.LogDensity(motion));
  }
  return std::log(density);
}

}  // namespace gmapping_spa::frontend
