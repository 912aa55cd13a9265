// SPDX-License-Identifier: BSD-3-Clause
// The odometry motion model p(x_t | x_{t-1}, u_t).
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MOTION_MODEL_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MOTION_MODEL_H_

#include <Eigen/Core>

#include "backend/counter_random.h"
#include "backend/se2.h"
#include "frontend/particle_filter/control.h"

namespace gmapping_spa::particle_filter {

// Gaussian noise on the increments of the odometry, in the frame of the pose before the motion. Its
// standard deviations grow with the motion, as in GMapping. GMapping's own are two to seven times
// these (experiments/flags/gmapping.flags), and it draws at each scan, so that they partly cancel:
// where a scan binds the robot they do not matter, and where it does not, along corridors and in
// halls, the way driven is lost by them.
class MotionModel {
 public:
  struct Options {
    double linear_per_linear = 0.05;    // m of noise along the motion per m driven ("srr")
    double linear_per_angular = 0.03;   // m per rad turned ("str")
    double lateral_per_linear = 0.03;   // m of noise across the motion per m driven ("sxy")
    double angular_per_linear = 0.03;   // rad per m driven ("srt")
    double angular_per_angular = 0.05;  // rad per rad turned ("stt")
    double linear_floor_m = 0.01;       // of a robot that stands still: sensors and clocks jitter
    double angular_floor_rad = 0.005;
    // Whether noise is added to the increment of each scan, so that the robot walks along at
    // random, as in GMapping; else once to the motion of the whole step.
    bool noise_at_each_scan = false;
    friend bool operator==(const Options&, const Options&) = default;
  };

  explicit MotionModel(const Options& options);

  // Standard deviations of (x, y, theta) of the increment `u`.
  Eigen::Vector3d Sigmas(const backend::SE2& u) const;

  // Eq. (9): draws x_t given x_{t-1} and the odometry increment u = Between(odom_{t-1}, odom_t).
  // `noise`: a factor on the standard deviations.
  backend::SE2 Sample(const backend::SE2& world_T_previous, const backend::SE2& u, double noise,
                      backend::CounterRandom* random) const;

  // Covariance of x_t in the world frame: the mean is world_T_previous * u.
  Eigen::Matrix3d Covariance(const backend::SE2& world_T_previous, const backend::SE2& u,
                             double noise) const;

  // The same of the motion of a step of the filter, with noise as Options::noise_at_each_scan says.
  // The covariance of many increments is that of the linearized walk.
  backend::SE2 Sample(const backend::SE2& world_T_previous, const Control& control,
                      backend::CounterRandom* random) const;
  Eigen::Matrix3d Covariance(const backend::SE2& world_T_previous, const Control& control) const;

 private:
  bool IsWalk(const Control& control) const {
    return options_.noise_at_each_scan && !control.increments.empty();
  }

  Options options_;
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_MOTION_MODEL_H_
