// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/pose_sampling.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::CounterRandom;
using backend::SE2;

class GaussianSampling : public PoseSampling {
 public:
  SampledPose Sample(const SE2& match_world_T_robot, const PoseGaussian& motion_prior,
                     scan_matching::EndpointModel* model, CounterRandom* random) const override {
    const Proposal proposal =  // eqs. (11) and (12)
        ComputeProposal(model, match_world_T_robot, motion_prior);
    return {SampleGaussian(proposal.gaussian, random), proposal.log_eta,
            proposal.gaussian.covariance};
  }
};

class MatchAsSample : public PoseSampling {
 public:
  explicit MatchAsSample(bool needs_covariance) : needs_covariance_(needs_covariance) {}

  SampledPose Sample(const SE2& match_world_T_robot, const PoseGaussian& motion_prior,
                     scan_matching::EndpointModel* model,
                     CounterRandom* /*random*/) const override {
    return {match_world_T_robot, model->LogLikelihood(match_world_T_robot),
            needs_covariance_
                ? ComputeProposal(model, match_world_T_robot, motion_prior).gaussian.covariance
                : motion_prior.covariance};
  }

 private:
  bool needs_covariance_;
};

}  // namespace

std::shared_ptr<const PoseSampling> MakePoseSampling(PoseSampling::Kind kind,
                                                     bool needs_covariance) {
  if (kind == PoseSampling::Kind::kMatch) return std::make_shared<MatchAsSample>(needs_covariance);
  return std::make_shared<GaussianSampling>();
}

}  // namespace gmapping_spa::particle_filter
