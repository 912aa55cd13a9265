// SPDX-License-Identifier: BSD-3-Clause
// The velocity of the robot, as far as it predicts the next motion.
#include <Eigen/Core>
#include <algorithm>

#include "frontend/lidar_odometry.h"

namespace gmapping_spa::frontend {

using backend::SE2;

namespace {

constexpr double kMaxRatio = 2.0;   // of the times of two scans in succession
constexpr double kMaxChange = 3.0;  // of the motion from scan to scan, in standard deviations

}  // namespace

// Loggers may stamp scans when they write them, several at once: times are taken with a pinch of
// salt.
double LidarOdometry::DurationRatio(double duration_s) const {
  return std::clamp(duration_s / usual_duration_s_, 1.0 / kMaxRatio, kMaxRatio);
}

SE2 LidarOdometry::SameVelocity(double duration_s) const {
  return backend::Exp(DurationRatio(duration_s) * usual_motion_);
}

void LidarOdometry::LearnVelocity(const Match& match, double duration_s) {
  // Scans out of order or matched wrongly seem to jump; robots do not.
  const Eigen::Vector3d motion =
      backend::Log(Between(odom_T_robot_, match.odom_T_robot)) / DurationRatio(duration_s);
  const MotionPrior::Options& prior = options_.prior;
  const double square_s2 = usual_duration_s_ * usual_duration_s_;
  const double sigma_m = prior.velocity_floor_m + prior.acceleration_m_s2 * square_s2;
  const double sigma_rad = prior.velocity_floor_rad + prior.angular_acceleration_rad_s2 * square_s2;
  const Eigen::Array3d limit = kMaxChange * Eigen::Array3d(sigma_m, sigma_m, sigma_rad);
  const Eigen::Vector3d change = (motion - usual_motion_).array().max(-limit).min(limit).matrix();
  usual_motion_ += change;
}

}  // namespace gmapping_spa::frontend
