// SPDX-License-Identifier: BSD-3-Clause
// What the wheels get wrong all the time: wheels of unequal size, a wrong track width.
#ifndef GMAPPING_SPA_FRONTEND_WHEEL_CALIBRATION_H_
#define GMAPPING_SPA_FRONTEND_WHEEL_CALIBRATION_H_

#include <Eigen/Core>

#include "backend/se2.h"

namespace gmapping_spa::frontend {

// Learns from what the scans say how much turn is missing in what the wheels say, by the way driven
// and by the turn. A scan of few beams says little more about the heading than the wheels do: a
// part of what they are off by at each step, always to the same side, would go into the path.
class WheelCalibration {
 public:
  // Turn that is missing, by the way driven forward and by the turn; 0 while noise may feign it.
  double rad_per_m() const { return missing_.x(); }
  double rad_per_rad() const { return missing_.y(); }
  bool corrects() const { return !missing_.isZero(0.0); }

  // The step of the wheels as it should have been.
  backend::SE2 Corrected(const backend::SE2& wheels) const;

  // Sums up a step that the robot has made.
  void Add(const backend::SE2& wheels, const backend::SE2& motion);
  // Learns from the steps since the last call. `variance_rad2`: of the sum of their turns, as far
  // as it is noise.
  void Learn(double variance_rad2);

  // For sessions (frontend/session).
  template <typename Archive>
  void serialize(Archive& archive) {
    archive(missing_, information_, vector_, way_and_turn_, missing_rad_);
  }

 private:
  Eigen::Vector2d missing_ = Eigen::Vector2d::Zero();
  // Of the regression of missing turns on (way, turn), without what is usual.
  Eigen::Matrix2d information_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d vector_ = Eigen::Vector2d::Zero();
  // Since the last call of Learn.
  Eigen::Vector2d way_and_turn_ = Eigen::Vector2d::Zero();
  double missing_rad_ = 0.0;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_WHEEL_CALIBRATION_H_
