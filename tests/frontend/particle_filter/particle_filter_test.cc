// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/particle_filter.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "frontend/scan_matching/hill_climbing.h"
#include "tests/frontend/particle_filter/tour.h"
#include "tests/frontend/room_map.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;

TEST(ParticleFilter, ResultDependsOnTheSeedAndNothingElse) {
  const Tour first(Particles(3, 1, 5)), again(Particles(3, 1, 5)), other(Particles(3, 1, 6));
  EXPECT_TRUE(SamePoses(first.filter, again.filter));
  EXPECT_FALSE(SamePoses(first.filter, other.filter));
}

TEST(ParticleFilter, PathHasAPoseForTheStartAndForEveryUpdate) {
  const Tour run(Particles(4));
  for (int i = 0; i < 4; ++i) {
    const std::vector<SE2> path = PosesOf(run.filter.Path(i));
    ASSERT_EQ(path.size(), run.updates.size() + 1);
    EXPECT_TRUE((path.front() == SE2{}));
    EXPECT_TRUE(path.back() == run.filter.particles()[i].world_T_robot);
  }
}

TEST(ParticleFilter, MotionsLeadAlongThePath) {
  const Tour run(Particles(4));
  for (int i = 0; i < 4; ++i) {
    const std::vector<TrajectoryTree::Vertex> path = run.filter.Path(i);
    EXPECT_TRUE(path.back().motion.previous_T_robot ==
                run.filter.particles()[i].motion.previous_T_robot);
    for (std::size_t k = 1; k < path.size(); ++k) {
      EXPECT_EQ(path[k].step, static_cast<int>(k));
      EXPECT_TRUE(path[k].motion.matched);
      const SE2 expected = Between(path[k - 1].world_T_robot, path[k].world_T_robot);
      EXPECT_TRUE(path[k].motion.previous_T_robot == expected) << k;
    }
  }
}

TEST(ParticleFilter, MotionsAreTheControlInputsIfAskedFor) {
  ParticleFilter::Options options = Particles(4);
  options.edges.measurement = EdgeModel::Measurement::kControl;
  const Tour run(options);
  const std::vector<SE2> truth = Drive();
  for (int i = 0; i < 4; ++i) {
    const std::vector<TrajectoryTree::Vertex> path = run.filter.Path(i);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const SE2 control = MeasuredIncrement(truth[k - 1], truth[k]);
      EXPECT_TRUE(path[k].motion.previous_T_robot == control) << k;
    }
  }
  EXPECT_TRUE(SamePoses(run.filter, Tour(Particles(4)).filter));  // the filter itself does not care
}

TEST(ParticleFilter, TracksARobotInARoomWithFiveParticles) {
  const std::vector<SE2> truth = Drive();
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Tour run(Particles(5, 1, seed));
    const std::vector<SE2> path = PosesOf(run.filter.Path(run.filter.BestParticle()));
    double worst_m = 0.0, worst_rad = 0.0;
    SE2 dead_reckoning;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (i > 0) dead_reckoning = dead_reckoning * MeasuredIncrement(truth[i - 1], truth[i]);
      const SE2 error = Between(truth[i], path[i]);
      worst_m = std::max(worst_m, error.translation().norm());
      worst_rad = std::max(worst_rad, std::abs(error.theta));
    }
    EXPECT_LT(worst_m, 0.06);
    EXPECT_LT(worst_rad, 0.02);
    // Not by the odometry's merit.
    EXPECT_GT(Between(truth.back(), dead_reckoning).translation().norm(), 0.12);
    for (const ParticleFilter::UpdateResult& update : run.updates)
      EXPECT_EQ(update.failed_matches, 0);
  }
}

class OneUpdate : public testing::Test {
 protected:
  explicit OneUpdate(double resample_threshold = 1.1) {  // above 1: after every step
    ParticleFilter::Options options = Particles(8);
    options.resample_threshold = resample_threshold;
    options.obs_sigma_gain = 0.05;  // so that weights differ enough for twins
    filter_ = std::make_unique<ParticleFilter>(
        options, std::make_shared<scan_matching::HillClimbing>(
                     scan_matching::HillClimbing::Options{}, options.endpoint));
    filter_->Start(synthetic::Scan(synthetic::Room(), {}), {});
  }
  ParticleFilter::UpdateResult Step(const SE2& truth, const SE2& increment) {
    return filter_->Update(synthetic::Scan(synthetic::Room(), truth), {{increment}});
  }
  std::unique_ptr<ParticleFilter> filter_;
};

TEST_F(OneUpdate, StartSharesOneMap) {
  for (const Particle& particle : filter_->particles()) {
    EXPECT_TRUE(SameMap(particle.map, synthetic::MapFrom(synthetic::Room(), {SE2{}})));
    EXPECT_EQ(particle.map.CountOwnTiles(), 0u);
  }
}

TEST_F(OneUpdate, TwinsShareAllTilesAfterResampling) {
  int pairs = 0;
  for (int i = 1; i <= 6; ++i) {
    const SE2 truth{0.2 * i, 0.0, 0.0};
    ASSERT_TRUE(Step(truth, {0.2, 0, 0}).resampled);
    const std::vector<Particle>& particles = filter_->particles();
    for (std::size_t k = 0; k < particles.size(); ++k) {
      EXPECT_EQ(particles[k].log_weight, 0.0);
      if (k == 0 || particles[k].leaf != particles[k - 1].leaf) continue;
      ++pairs;
      EXPECT_TRUE(particles[k].world_T_robot == particles[k - 1].world_T_robot);
      EXPECT_EQ(particles[k].map.CountOwnTiles(), 0u);
      EXPECT_EQ(particles[k - 1].map.CountOwnTiles(), 0u);
    }
  }
  EXPECT_GT(pairs, 0);
}

TEST_F(OneUpdate, FailedMatchFallsBackToTheMotionModel) {
  sensor::LaserScan blind;  // no beams: nothing to match
  const ParticleFilter::UpdateResult update = filter_->Update(blind, {{SE2{1.0, 0.0, 0.0}}});
  EXPECT_EQ(update.failed_matches, 8);
  EXPECT_NEAR(update.effective_sample_size, 8.0, 1e-9);
  const Eigen::Vector3d sigmas = MotionModel({}).Sigmas({1, 0, 0});
  const Eigen::Matrix3d information = sigmas.array().square().inverse().matrix().asDiagonal();
  for (const Particle& particle : filter_->particles()) {
    EXPECT_FALSE(particle.motion.matched);
    EXPECT_TRUE(particle.motion.information.isApprox(information, 1e-9));
    EXPECT_TRUE(particle.motion.previous_T_robot == particle.world_T_robot);  // from the origin
    EXPECT_LT(std::abs(particle.world_T_robot.x - 1.0), 4.0 * sigmas.x());
  }
  EXPECT_FALSE(filter_->particles()[0].world_T_robot == filter_->particles()[1].world_T_robot);
}

class OneUpdateWithoutResampling : public OneUpdate {
 protected:
  OneUpdateWithoutResampling() : OneUpdate(0.0) {}
};

TEST_F(OneUpdateWithoutResampling, ParticlesShareOutWhatTheControlInputDoesNotDecide) {
  const sensor::LaserScan blind;
  filter_->Update(blind, {{{1.0, 0.0, 0.0}, 0.75}, {{-1.0, 0.0, 0.0}, 0.25}});
  int ahead = 0;
  for (const Particle& particle : filter_->particles()) ahead += particle.world_T_robot.x > 0.0;
  EXPECT_EQ(ahead, 6);
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
