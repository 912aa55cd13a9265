// SPDX-License-Identifier: BSD-3-Clause
// The improved proposal of GMapping: a Gaussian that has seen the scan.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PROPOSAL_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PROPOSAL_H_

#include <Eigen/Core>

#include "backend/counter_random.h"
#include "backend/se2.h"
#include "frontend/scan_matching/endpoint_model.h"

namespace gmapping_spa::particle_filter {

// A pose with Gaussian uncertainty of (x, y, theta), in the world frame.
struct PoseGaussian {
  backend::SE2 mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

struct Proposal {
  PoseGaussian gaussian;
  double log_eta = 0.0;  // log of the integral of p(z | m, x) p(x | x_{t-1}, u) over x
};

// Evaluates p(z | m, x) p(x | x_{t-1}, u), of `model` and `motion_prior`, at samples around the
// scan matcher's optimum and fits a Gaussian to it, eqs. (11) and (12); their weighted sum is eta,
// the factor of the importance weight.
//
// The region that the samples must cover differs in size by orders of magnitude: along a corridor a
// scan does not constrain it, across it millimetres. Therefore they form a 3 x 3 x 3 lattice along
// the principal axes of the target's curvature at the optimum, taken over a map cell, sqrt(3)
// standard deviations to either side: wide where only the motion prior ends it.
Proposal ComputeProposal(scan_matching::EndpointModel* model,
                         const backend::SE2& optimum_world_T_robot,
                         const PoseGaussian& motion_prior);

// Eq. (13): draws a pose from N(mean, covariance).
backend::SE2 SampleGaussian(const PoseGaussian& gaussian, backend::CounterRandom* random);

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PROPOSAL_H_
