// SPDX-License-Identifier: BSD-3-Clause
// What is known about the motion between two scans before the second one is looked at.
#ifndef GMAPPING_SPA_FRONTEND_MOTION_PRIOR_H_
#define GMAPPING_SPA_FRONTEND_MOTION_PRIOR_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "backend/se2.h"
#include "frontend/sensor/odometry_check.h"

namespace gmapping_spa::frontend {

// One guess at the motion, in the robot frame before it.
struct MotionHypothesis {
  backend::SE2 motion;
  double sigma_m = 0.0;  // standard deviation, the same along x and y
  double sigma_rad = 0.0;
  double weight = 0.0;           // prior probability
  bool way_is_measured = false;  // by wheels that lately did about as expected
  // How much surer than that it has proved to be where it is fused with a scan, in variances.
  double gain_m = 1.0;
  double gain_rad = 1.0;

  // Of (x, y, theta), gains included; the same in every frame.
  Eigen::Matrix3d Information() const;
  // Squared Mahalanobis distance.
  double SquaredDistance(const backend::SE2& other) const;
  // Whether the other motion is within three standard deviations.
  bool AgreesWith(const backend::SE2& other) const;
  double LogDensity(const backend::SE2& other) const;  // of the normal distribution, times weight
};

// What the wheels say, and how far they are to be trusted.
struct WheelMotion {
  backend::SE2 motion;
  double sigma_factor_m = 1.0;  // on the standard deviations
  double sigma_factor_rad = 1.0;
  double wrong = 0.01;    // probability that it has nothing to do with the motion
  bool tells_way = true;  // otherwise the way is a guess, as sure as that of the same velocity
  // Of MotionHypothesis.
  double gain_m = 1.0;
  double gain_rad = 1.0;
};

// A mixture: what the wheels say, going on at the same velocity, and anything that a robot can do.
// Wheels slip, restart, come late or drop out; velocities change within limits. So no one of
// them is ever the whole truth, and none is ever left out without a reason.
class MotionPrior {
 public:
  struct Options {
    // Standard deviations of the wheels' increment.
    double floor_m = 0.01;
    double m_per_m = 0.1;
    double m_per_rad = 0.05;  // where the laser sits on the robot is known roughly
    double floor_rad = 0.005;
    double rad_per_m = 0.05;
    double rad_per_rad = 0.1;
    // Of the change of velocity that robots make.
    double acceleration_m_s2 = 1.0;
    double angular_acceleration_rad_s2 = 3.0;
    double velocity_floor_m = 0.02;  // of the last motion, which is a measurement as well
    double velocity_floor_rad = 0.02;
    double anything = 1e-3;  // probability that the motion is none of the guesses
    // What a robot can do.
    double max_speed_m_s = 5.0;
    double max_turn_rad_s = 6.0;
    friend bool operator==(const Options&, const Options&) = default;
  };

  // `wheels`: nothing where they have no say. `same_velocity`: the motion if the robot goes on as
  // before. `steps`: since the pose was last sure; the errors of all of them add up.
  MotionPrior(const Options& options, const std::optional<WheelMotion>& wheels,
              const backend::SE2& same_velocity, double duration_s, int steps = 1);

  // The likeliest first.
  const std::vector<MotionHypothesis>& hypotheses() const { return hypotheses_; }
  // Whether one guess could stand for the others.
  bool GuessesAgree() const;
  // Log of the density of the mixture, per m^2 rad.
  double LogDensity(const backend::SE2& motion) const;
  // How far a robot can get from where it would be by any of the guesses.
  double reach_m() const { return reach_m_; }
  double reach_rad() const { return reach_rad_; }

 private:
  std::vector<MotionHypothesis> hypotheses_;
  double reach_m_;
  double reach_rad_;
  double anything_density_;
};

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_MOTION_PRIOR_H_
