// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/proposal.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using SymmetricEigenSolver = Eigen::SelfAdjointEigenSolver<Matrix3d>;

constexpr double kAngularStep_rad = 0.01;  // moves an end point at 5 m by a cell of 0.05 m

// Minus the Hessian of f at zero, where it is `center`, by central differences with unit step,
// without the parts that curve upward: there the likelihood does not bound the pose.
template <typename Function>
Matrix3d Curvature(double center, const Function& f) {
  Matrix3d curvature;
  for (int i = 0; i < 3; ++i) {
    const Vector3d ei = Vector3d::Unit(i);
    curvature(i, i) = 2.0 * center - f(ei) - f(-ei);
    for (int j = 0; j < i; ++j) {
      // Both diagonals: beside a wall, where the likelihood has its floor, one alone misleads.
      const Vector3d ej = Vector3d::Unit(j);
      curvature(i, j) = (f(ei - ej) + f(ej - ei) - f(ei + ej) - f(-ei - ej)) / 4.0;
      curvature(j, i) = curvature(i, j);
    }
  }
  const SymmetricEigenSolver eigen(curvature);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

}  // namespace

Proposal ComputeProposal(scan_matching::EndpointModel* model, const SE2& optimum_world_T_robot,
                         const PoseGaussian& motion_prior) {
  const SE2& optimum = optimum_world_T_robot;
  const Matrix3d prior_information = motion_prior.covariance.inverse();
  const double log_prior_scale =
      -0.5 * std::log(motion_prior.covariance.determinant()) - 1.5 * std::log(2 * std::numbers::pi);

  // Columns: a standard deviation along each principal axis of the target. The first pass probes a
  // cell far, too coarse across a wall; the second one probes where the first one ended.
  Matrix3d axes =
      Vector3d(model->resolution_m(), model->resolution_m(), kAngularStep_rad).asDiagonal();
  const double log_likelihood_at_optimum = model->LogLikelihood(optimum);
  for (int pass = 0; pass < 2; ++pass) {
    const Matrix3d information = Curvature(log_likelihood_at_optimum,
                                           [&](const Vector3d& q) {
                                             return model->LogLikelihood(Plus(optimum, axes * q));
                                           }) +
                                 axes.transpose() * prior_information * axes;
    const SymmetricEigenSolver eigen(information);
    axes =
        axes * eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().cwiseSqrt().asDiagonal();
  }
  const Matrix3d lattice = std::numbers::sqrt3 * axes;

  constexpr int kSamples = 27;
  std::array<Vector3d, kSamples> offsets;
  Eigen::Array<double, kSamples, 1> log_target;
  for (int k = 0; k < kSamples; ++k) {
    const Eigen::Vector3i step(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    offsets[k] = lattice * Vector3d(step.cast<double>());
    const SE2 sample = Plus(optimum, offsets[k]);
    const Vector3d innovation = Minus(sample, motion_prior.mean);
    log_target[k] = model->LogLikelihood(sample) + log_prior_scale -
                    0.5 * innovation.dot(prior_information * innovation);
  }
  const double max_log_target = log_target.maxCoeff();
  const Eigen::Array<double, kSamples, 1> target = (log_target - max_log_target).exp();
  const double sum = target.sum();

  Vector3d mean = Vector3d::Zero();  // eq. (11), relative to the optimum
  for (int k = 0; k < kSamples; ++k) mean += target[k] / sum * offsets[k];
  Matrix3d covariance = Matrix3d::Zero();  // eq. (12)
  for (int k = 0; k < kSamples; ++k) {
    const Vector3d d = offsets[k] - mean;
    covariance += target[k] / sum * d * d.transpose();
  }
  // A target much narrower than the lattice leaves a single sample with weight; the curvature then
  // still bounds the variance from below.
  covariance += 1e-3 / 3.0 * lattice * lattice.transpose();

  Proposal proposal;
  proposal.gaussian = {Plus(optimum, mean), covariance};
  // The sum times the volume of a lattice cell: comparable between particles whose lattices differ.
  proposal.log_eta = max_log_target + std::log(sum) + std::log(std::abs(lattice.determinant()));
  return proposal;
}

SE2 SampleGaussian(const PoseGaussian& gaussian, backend::CounterRandom* random) {
  const Matrix3d root = gaussian.covariance.llt().matrixL();
  Vector3d normal;
  for (double& value : normal) value = random->Gaussian();
  return Plus(gaussian.mean, root * normal);
}

}  // namespace gmapping_spa::particle_filter
