// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/wheel_calibration.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace gmapping_spa::frontend {

using backend::SE2;

namespace {

// Standard deviations of what may be missing, (rad per m, rad per rad).
const Eigen::Array2d kUsual(0.05, 0.1);
constexpr double kKeep = 0.99;         // part of what is known that the next block still counts
constexpr double kFeigned = 9.0;       // squared standard deviations
constexpr double kRobustSigmas = 3.0;  // wheels slip: width of the Cauchy weight

}  // namespace

SE2 WheelCalibration::Corrected(const SE2& wheels) const {
  SE2 corrected = wheels;
  corrected.theta += missing_.dot(Eigen::Vector2d(wheels.x, wheels.theta));
  return corrected;
}

void WheelCalibration::Add(const SE2& wheels, const SE2& motion) {
  way_and_turn_ += Eigen::Vector2d(wheels.x, wheels.theta);
  missing_rad_ += backend::WrapAngle(motion.theta - wheels.theta);
}

void WheelCalibration::Learn(double variance_rad2) {
  const double off_rad = missing_rad_ - missing_.dot(way_and_turn_);
  const double weight = 1.0 / (variance_rad2 + off_rad * off_rad / (kRobustSigmas * kRobustSigmas));
  information_ = kKeep * information_ + weight * way_and_turn_ * way_and_turn_.transpose();
  vector_ = kKeep * vector_ + weight * missing_rad_ * way_and_turn_;
  Eigen::Matrix2d regular = information_;
  regular.diagonal() += kUsual.square().inverse().matrix();
  missing_ = regular.ldlt().solve(vector_);
  // Shrunk by what noise may feign (James and Stein 1961): good wheels are left as they are.
  const double squared_sigmas = missing_.dot(regular * missing_);
  missing_ *= std::max(1.0 - kFeigned / std::max(squared_sigmas, kFeigned), 0.0);
  way_and_turn_.setZero();
  missing_rad_ = 0.0;
}

}  // namespace gmapping_spa::frontend
