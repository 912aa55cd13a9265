// Wheel odometry with normal noise, and with slip that no normal distribution describes.
#ifndef GMAPPING_SPA_EXPERIMENTS_SIMULATION_ODOMETRY_H_
#define GMAPPING_SPA_EXPERIMENTS_SIMULATION_ODOMETRY_H_

#include <cstdint>

#include "backend/se2.h"
#include "experiments/simulation/differential_drive.h"

namespace gmapping_spa::simulation {

// Variances grow with the motion, so that the noise of a path does not depend on the length of a
// step: after d m and a rad, (deviation per root metre)^2 * d + (deviation per root radian)^2 * a.
struct OdometryOptions {
  double wheel_base_m = 0.5;

  double noise = 1.0;  // factor on the four standard deviations below
  double translation_m_per_root_m = 0.01;
  double translation_m_per_root_rad = 0.005;
  double rotation_rad_per_root_m = 0.008;
  double rotation_rad_per_root_rad = 0.012;

  // The paper's interferences other than Gaussian noise. Probability per metre that an event
  // begins: with equal chances, one wheel reports (1 + e) times its travel for a while, or the
  // robot is knocked and the heading jumps; e and the jump are normal.
  double slip_probability_per_m = 0.02;
  double slip_duration_s = 0.4;
  double slip_deviation = 0.2;
  double jump_deviation_rad = 0.1;
};

class Odometry {
 public:
  Odometry(const OdometryOptions& options, std::uint64_t seed) : options_(options), seed_(seed) {}

  // Takes in a step of true motion.
  void Advance(const BodyVelocity& true_velocity, double duration_s);

  // What the robot believes: starts at the identity.
  const backend::SE2& odom_T_robot() const { return odom_T_robot_; }
  const BodyVelocity& measured_velocity() const { return measured_velocity_; }
  int slip_events() const { return slip_events_; }

 private:
  OdometryOptions options_;
  std::uint64_t seed_;
  std::uint32_t step_ = 0;
  backend::SE2 odom_T_robot_;
  BodyVelocity measured_velocity_;

  // How many times its travel each wheel reports; not 1 until slip_left_s_ is over.
  double left_scale_ = 1.0, right_scale_ = 1.0;
  double slip_left_s_ = 0.0;
  int slip_events_ = 0;
};

}  // namespace gmapping_spa::simulation

#endif  // GMAPPING_SPA_EXPERIMENTS_SIMULATION_ODOMETRY_H_
