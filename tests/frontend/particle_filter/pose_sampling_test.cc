// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/pose_sampling.h"

#include <gtest/gtest.h>

#include "frontend/particle_filter/motion_model.h"
#include "tests/frontend/room_map.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::CounterRandom;
using backend::SE2;

class PoseSamplingInARoom : public testing::Test {
 protected:
  SampledPose Sample(PoseSampling::Kind kind, bool needs_covariance = true) {
    CounterRandom random{1, 0};
    return MakePoseSampling(kind, needs_covariance)->Sample(match_, prior_, &model_, &random);
  }

  const map::OccupancyGrid grid_ = synthetic::RoomMap();
  const SE2 match_{0.4, -0.3, 0.8};
  const scan_matching::ScanPoints points_ =
      scan_matching::MakeScanPoints(synthetic::Scan(synthetic::Room(), match_));
  scan_matching::EndpointModel model_{{}, &grid_, &points_};
  const PoseGaussian prior_{match_ * SE2{0.02, 0, 0.01},
                            MotionModel({}).Covariance(match_, {1, 0, 0}, 1.0)};
};

TEST_F(PoseSamplingInARoom, GaussianDrawsFromTheImprovedProposalAndWeightsByItsIntegral) {
  const SampledPose sampled = Sample(PoseSampling::Kind::kGaussian);
  const Proposal proposal = ComputeProposal(&model_, match_, prior_);
  CounterRandom same(1, 0);
  EXPECT_TRUE(sampled.world_T_robot == SampleGaussian(proposal.gaussian, &same));
  EXPECT_EQ(sampled.log_factor, proposal.log_eta);
  EXPECT_EQ(sampled.world_covariance, proposal.gaussian.covariance);
}

TEST_F(PoseSamplingInARoom, MatchIsThePoseItselfWeightedByItsLikelihood) {
  const SampledPose sampled = Sample(PoseSampling::Kind::kMatch);
  EXPECT_TRUE(sampled.world_T_robot == match_);
  EXPECT_EQ(sampled.log_factor, model_.LogLikelihood(match_));
}

TEST_F(PoseSamplingInARoom, MatchHasTheCovarianceOfTheProposalWhereItIsNeeded) {
  EXPECT_EQ(Sample(PoseSampling::Kind::kMatch).world_covariance,
            ComputeProposal(&model_, match_, prior_).gaussian.covariance);
  EXPECT_EQ(Sample(PoseSampling::Kind::kMatch, false).world_covariance, prior_.covariance);
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
