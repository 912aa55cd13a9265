// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/simulation/odometry.h"

#include <cmath>

#include "backend/counter_random.h"
#include "experiments/simulation/random_streams.h"

namespace gmapping_spa::simulation {
Odometry::Odometry(const OdometryOptions& options, std::uint64_t seed)
    : options_(options), seed_(seed) {
  backend::CounterRandom random(seed, kBiasStream);
  const double scale =
      1.0 + options.interference * options.wheel_scale_deviation * random.Gaussian();
  const double ratio = options.interference * options.wheel_ratio_deviation * random.Gaussian();
  bias_ = {scale * (1.0 - ratio / 2.0), scale * (1.0 + ratio / 2.0)};
}

double Odometry::ProbabilityOf(double events_per_m, double distance_m) const {
  if (elapsed_s_ < options_.calm_s) return 0.0;
  return -std::expm1(-events_per_m * distance_m);
}

WheelSpeeds Odometry::Slipped(const WheelSpeeds& wheels, double distance_m, double duration_s) {
  // Half a step of tolerance: rounding must not add one.
  if (slip_left_s_ < duration_s / 2.0) slip_ = {};
  backend::CounterRandom random(seed_, kSlipStream, step_);
  if (random.Uniform() < ProbabilityOf(options_.slips_per_m, distance_m)) {
    ++slips_;
    (random.Uniform() < 0.5 ? slip_.left : slip_.right) =
        1.0 + options_.interference * options_.slip_deviation * random.Gaussian();
    slip_left_s_ = options_.slip_duration_s;
  }
  slip_left_s_ -= duration_s;
  return {bias_.left * slip_.left * wheels.left_m_s, bias_.right * slip_.right * wheels.right_m_s};
}

Odometry::Jump Odometry::Bump(double distance_m) {
  backend::CounterRandom random(seed_, kBumpStream, step_);
  if (random.Uniform() >= ProbabilityOf(options_.bumps_per_m, distance_m)) return {};
  ++bumps_;
  Jump jump;
  jump.rotation_rad = options_.interference * options_.bump_deviation_rad * random.Gaussian();
  jump.translation_m = options_.interference * options_.bump_deviation_m * random.Gaussian();
  return jump;
}

void Odometry::Integrate(const BodyVelocity& true_velocity, double duration_s) {
  if (options_.silent) return;
  const double distance_m = std::abs(true_velocity.linear_m_s) * duration_s;
  const double angle_rad = std::abs(true_velocity.angular_rad_s) * duration_s;
  const BodyVelocity reported = ToBodyVelocity(
      Slipped(ToWheelSpeeds(true_velocity, options_.wheel_base_m), distance_m, duration_s),
      options_.wheel_base_factor * options_.wheel_base_m);
  const Jump jump = Bump(distance_m);
  backend::CounterRandom random(seed_, kOdometryStream, step_);
  const double translation_m =
      options_.noise *
          std::hypot(options_.translation_m_per_root_m * std::sqrt(distance_m),
                     options_.translation_m_per_root_rad * std::sqrt(angle_rad)) *
          random.Gaussian() +
      jump.translation_m;
  const double rotation_rad =
      options_.noise *
          std::hypot(options_.rotation_rad_per_root_m * std::sqrt(distance_m),
                     options_.rotation_rad_per_root_rad * std::sqrt(angle_rad)) *
          random.Gaussian() +
      jump.rotation_rad;
  measured_velocity_ = {reported.linear_m_s + translation_m / duration_s,
                        reported.angular_rad_s + rotation_rad / duration_s};
  odom_T_robot_ = Drive(odom_T_robot_, measured_velocity_, duration_s);
  ++step_;
  elapsed_s_ += duration_s;
}

}  // namespace gmapping_spa::simulation
