// SPDX-License-Identifier: BSD-3-Clause
// How a particle whose scan was matched gets its new pose, and the weight that goes with it.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_POSE_SAMPLING_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_POSE_SAMPLING_H_

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "backend/counter_random.h"
#include "backend/se2.h"
#include "frontend/particle_filter/proposal.h"
#include "frontend/scan_matching/endpoint_model.h"

namespace gmapping_spa::particle_filter {

struct SampledPose {
  backend::SE2 world_T_robot;
  // Log of the factor of the importance weight: target over proposal (step 5).
  double log_factor = 0.0;
  Eigen::Matrix3d world_covariance;  // of the new pose given the one before, eq. (12)
};

// Implementations keep no state, so that threads can share one.
class PoseSampling {
 public:
  enum class Kind : std::uint8_t {
    kGaussian,  // a draw from the improved proposal (Grisetti, Stachniss, Burgard 2007), weight eta
    kMatch      // the match itself, weighted by its likelihood, as the published program does
  };

  virtual ~PoseSampling() = default;

  // `match_world_T_robot`: what eq. (8) found. `model`: how well the scan fits the particle's map.
  virtual SampledPose Sample(const backend::SE2& match_world_T_robot,
                             const PoseGaussian& motion_prior, scan_matching::EndpointModel* model,
                             backend::CounterRandom* random) const = 0;
};

// `needs_covariance`: without it the covariance of kMatch, which costs more than the match, is left
// at that of the motion prior.
std::shared_ptr<const PoseSampling> MakePoseSampling(PoseSampling::Kind kind,
                                                     bool needs_covariance);

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_POSE_SAMPLING_H_
