// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/motion_model.h"

#include <Eigen/Geometry>
#include <cmath>

namespace gmapping_spa::particle_filter {

using backend::SE2;

MotionModel::MotionModel(const Options& options) : options_(options) {}

Eigen::Vector3d MotionModel::Sigmas(const SE2& u) const {
  const Options& o = options_;
  const double dx = std::abs(u.x), dy = std::abs(u.y), turn = std::abs(u.theta);
  return {o.linear_floor_m + o.linear_per_linear * dx + o.lateral_per_linear * dy +
              o.linear_per_angular * turn,
          o.linear_floor_m + o.linear_per_linear * dy + o.lateral_per_linear * dx +
              o.linear_per_angular * turn,
          o.angular_floor_rad + o.angular_per_linear * std::hypot(dx, dy) +
              o.angular_per_angular * turn};
}

SE2 MotionModel::Sample(const SE2& world_T_previous, const SE2& u, double noise,
                        backend::CounterRandom* random) const {
  const Eigen::Vector3d sigma = noise * Sigmas(u);
  SE2 noisy = u;
  noisy.x += sigma.x() * random->Gaussian();
  noisy.y += sigma.y() * random->Gaussian();
  noisy.theta += sigma.z() * random->Gaussian();
  return world_T_previous * noisy;
}

Eigen::Matrix3d MotionModel::Covariance(const SE2& world_T_previous, const SE2& u,
                                        double noise) const {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(world_T_previous.theta).toRotationMatrix();
  return rotation * (noise * Sigmas(u)).array().square().matrix().asDiagonal() *
         rotation.transpose();
}

SE2 MotionModel::Sample(const SE2& world_T_previous, const Control& control,
                        backend::CounterRandom* random) const {
  if (!IsWalk(control)) return Sample(world_T_previous, control.motion, control.noise, random);
  SE2 world_T_robot = world_T_previous;
  for (const SE2& u : control.increments) {
    world_T_robot = Sample(world_T_robot, u, control.noise, random);
  }
  return world_T_robot;
}

Eigen::Matrix3d MotionModel::Covariance(const SE2& world_T_previous, const Control& control) const {
  if (!IsWalk(control)) return Covariance(world_T_previous, control.motion, control.noise);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  SE2 world_T_robot = world_T_previous;
  for (const SE2& u : control.increments) {
    const SE2 next = world_T_robot * u;
    Eigen::Matrix3d carry = Eigen::Matrix3d::Identity();  // derivative of next by world_T_robot
    carry(0, 2) = -(next.y - world_T_robot.y);
    carry(1, 2) = next.x - world_T_robot.x;
    covariance =
        carry * covariance * carry.transpose() + Covariance(world_T_robot, u, control.noise);
    world_T_robot = next;
  }
  return covariance;
}

}  // namespace gmapping_spa::particle_filter
