// SPDX-License-Identifier: BSD-3-Clause
// Wheel odometry with normal noise, and with interferences that no normal distribution describes.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_ODOMETRY_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_ODOMETRY_H_

#include <cstdint>

#include "backend/se2.h"
#include "experiments/simulation/differential_drive.h"

namespace gmapping_spa::simulation {

struct OdometryOptions {
  double wheel_base_m = 0.5;
  // The distance between the wheels that the odometry believes in, as a part of the true one: above
  // 1, it turns less than the robot does. A robot measured badly; neither noise nor drawn by the
  // seed, so `noise` and `interference` do not scale it.
  double wheel_base_factor = 1.0;
  bool silent = false;  // the robot never believes to move

  // Variances grow with the motion, so that the noise of a path does not depend on the length of a
  // step: after d m and a rad, (deviation per root metre)^2 * d + (deviation per root radian)^2 *
  // a.
  double noise = 1.0;  // factor on the four standard deviations below
  double translation_m_per_root_m = 0.01;
  double translation_m_per_root_rad = 0.005;
  double rotation_rad_per_root_m = 0.008;
  double rotation_rad_per_root_rad = 0.012;

  // The paper's interferences other than Gaussian noise. The factor is on the size of all of them;
  // where and when they come depends on the seed alone.
  double interference = 1.0;
  // Slip: one wheel reports (1 + e) times its travel for a while, e normal.
  double slips_per_m = 0.01;
  double slip_duration_s = 0.4;
  double slip_deviation = 0.2;
  // Bumps: within one step, what the robot believes jumps by a normal angle and, along its heading,
  // by a normal distance.
  double bumps_per_m = 0.01;
  double bump_deviation_rad = 0.1;
  double bump_deviation_m = 0.0;
  double calm_s = 0.0;  // until then there are neither slips nor bumps
  // Bias: wheels that are not as large as the robot thinks, the same all the way; standard
  // deviations of what the seed draws. Tyre, load and floor change both wheels by some tenths of a
  // per cent. Little of that differs from one wheel to the other: 0.03 % is a sixteenth of a
  // millimetre of a wheel of 20 cm, and turns the robot by 0.34 degrees in 10 m.
  double wheel_scale_deviation = 0.005;
  double wheel_ratio_deviation = 0.0003;
};

class Odometry {
 public:
  Odometry(const OdometryOptions& options, std::uint64_t seed);

  // Takes in a step of true motion.
  void Integrate(const BodyVelocity& true_velocity, double duration_s);

  // Of steps to come: OdometryOptions::noise and slips_per_m.
  void SetNoise(double factor) { options_.noise = factor; }
  void SetSlips(double slips_per_m) { options_.slips_per_m = slips_per_m; }

  // What the robot believes: starts at the identity.
  const backend::SE2& odom_T_robot() const { return odom_T_robot_; }
  const BodyVelocity& measured_velocity() const { return measured_velocity_; }
  int slips() const { return slips_; }
  int bumps() const { return bumps_; }

 private:
  // Of slips or bumps in a step, where so many are to be expected a metre.
  double ProbabilityOf(double events_per_m, double distance_m) const;
  // What the wheels report.
  WheelSpeeds Slipped(const WheelSpeeds& wheels, double distance_m, double duration_s);
  struct Jump {
    double translation_m = 0.0, rotation_rad = 0.0;
  };
  // What a knock does in this step; nothing in most.
  Jump Bump(double distance_m);

  OdometryOptions options_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  double elapsed_s_ = 0.0;
  backend::SE2 odom_T_robot_;
  BodyVelocity measured_velocity_;

  // How many times its travel each wheel reports: always, and on top of that until slip_left_s_ is
  // over.
  struct WheelFactors {
    double left = 1.0, right = 1.0;
  };
  WheelFactors bias_, slip_;
  double slip_left_s_ = 0.0;
  int slips_ = 0, bumps_ = 0;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_ODOMETRY_H_
