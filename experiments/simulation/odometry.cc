#include "experiments/simulation/odometry.h"

#include <cmath>

#include "backend/counter_random.h"
#include "experiments/simulation/random_streams.h"

namespace gmapping_spa::simulation {

void Odometry::Advance(const BodyVelocity& true_velocity, double duration_s) {
  const double distance_m = std::abs(true_velocity.linear_m_s) * duration_s;
  const double angle_rad = std::abs(true_velocity.angular_rad_s) * duration_s;

  // Half a step of tolerance: rounding must not add one.
  if (slip_left_s_ < duration_s / 2.0) left_scale_ = right_scale_ = 1.0;
  double jump_rad = 0.0;
  backend::CounterRandom slip(seed_, kSlipStream, step_);
  if (slip.Uniform() < -std::expm1(-options_.slip_probability_per_m * distance_m)) {
    ++slip_events_;
    const double kind = slip.Uniform();
    if (kind < 0.5) {
      jump_rad = options_.jump_deviation_rad * slip.Gaussian();
    } else {
      (kind < 0.75 ? left_scale_ : right_scale_) = 1.0 + options_.slip_deviation * slip.Gaussian();
      slip_left_s_ = options_.slip_duration_s;
    }
  }

  WheelSpeeds wheels = ToWheelSpeeds(true_velocity, options_.wheel_base_m);
  wheels.left_m_s *= left_scale_;
  wheels.right_m_s *= right_scale_;
  const BodyVelocity slipped = ToBodyVelocity(wheels, options_.wheel_base_m);

  backend::CounterRandom random(seed_, kOdometryStream, step_);
  const double translation_m =
      options_.noise *
      std::hypot(options_.translation_m_per_root_m * std::sqrt(distance_m),
                 options_.translation_m_per_root_rad * std::sqrt(angle_rad)) *
      random.Gaussian();
  const double rotation_rad =
      options_.noise *
      std::hypot(options_.rotation_rad_per_root_m * std::sqrt(distance_m),
                 options_.rotation_rad_per_root_rad * std::sqrt(angle_rad)) *
      random.Gaussian();
  measured_velocity_ = {slipped.linear_m_s + translation_m / duration_s,
                        slipped.angular_rad_s + (rotation_rad + jump_rad) / duration_s};
  odom_T_robot_ = Drive(odom_T_robot_, measured_velocity_, duration_s);
  slip_left_s_ -= duration_s;
  ++step_;
}

}  // namespace gmapping_spa::simulation
