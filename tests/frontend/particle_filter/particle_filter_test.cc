#include "frontend/particle_filter/particle_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "frontend/scan_matching/hill_climbing.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;

// Once around the room, half a metre or so at a time; starts at the origin.
std::vector<SE2> Drive() {
  std::vector<SE2> world_T_robot = {{}};
  for (int i = 0; i < 20; ++i) {
    world_T_robot.push_back(world_T_robot.back() * SE2{0.4, 0.02, 2.0 * std::acos(-1.0) / 20});
  }
  return world_T_robot;
}

// What the odometry claims: too short, and turning too little.
SE2 MeasuredIncrement(const SE2& from, const SE2& to) {
  const SE2 increment = Between(from, to);
  return {0.95 * increment.x, increment.y, 0.97 * increment.theta};
}

struct Tour {
  explicit Tour(const ParticleFilter::Options& options)
      : filter(options, std::make_shared<scan_matching::HillClimbing>(
                            scan_matching::HillClimbing::Options{}, options.endpoint)) {
    const std::vector<SE2> truth = Drive();
    filter.Start(synthetic::Scan(synthetic::Room(), truth[0]), truth[0]);
    for (std::size_t i = 1; i < truth.size(); ++i) {
      updates.push_back(filter.Advance(synthetic::Scan(synthetic::Room(), truth[i]),
                                       MeasuredIncrement(truth[i - 1], truth[i])));
    }
  }
  ParticleFilter filter;
  std::vector<ParticleFilter::Update> updates;
};

ParticleFilter::Options Particles(int particles, int threads = 1, std::uint64_t seed = 1) {
  ParticleFilter::Options options;
  options.particles = particles;
  options.threads = threads;
  options.seed = seed;
  options.initial_guesses = 5;
  options.resample_threshold = 0.9;  // so that it happens
  return options;
}

bool SameMap(const map::OccupancyGrid& a, const map::OccupancyGrid& b) {
  const map::OccupancyGrid::Extent extent = a.KnownExtent();
  if (!(extent.min == b.KnownExtent().min && extent.max == b.KnownExtent().max)) return false;
  for (int y = extent.min.y; y < extent.max.y; ++y) {
    for (int x = extent.min.x; x < extent.max.x; ++x) {
      const map::Cell &u = a.cell({x, y}), &v = b.cell({x, y});
      if (u.hits != v.hits || u.visits != v.visits) return false;
      if (u.mean_x != v.mean_x || u.mean_y != v.mean_y) return false;
    }
  }
  return true;
}

bool SamePoses(const ParticleFilter& a, const ParticleFilter& b) {
  for (std::size_t i = 0; i < a.particles().size(); ++i) {
    if (a.Path(static_cast<int>(i)) != b.Path(static_cast<int>(i))) return false;
    if (a.particles()[i].log_weight != b.particles()[i].log_weight) return false;
    if (a.particles()[i].log_likelihood != b.particles()[i].log_likelihood) return false;
  }
  return true;
}

TEST(ParticleFilter, ResultIsTheSameToTheBitWhateverTheNumberOfThreads) {
  const Tour one(Particles(6, 1));
  const bool resampled = std::any_of(one.updates.begin(), one.updates.end(),
                                     [](const auto& update) { return update.resampled; });
  EXPECT_TRUE(resampled);
  for (const int threads : {2, 4}) {
    const Tour many(Particles(6, threads));
    EXPECT_TRUE(SamePoses(one.filter, many.filter)) << threads;
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_TRUE(SameMap(one.filter.particles()[i].map, many.filter.particles()[i].map)) << i;
    }
  }
}

TEST(ParticleFilter, ResultDependsOnTheSeedAndNothingElse) {
  const Tour first(Particles(3, 1, 5)), again(Particles(3, 1, 5)), other(Particles(3, 1, 6));
  EXPECT_TRUE(SamePoses(first.filter, again.filter));
  EXPECT_FALSE(SamePoses(first.filter, other.filter));
}

TEST(ParticleFilter, PathHasAPoseForTheStartAndForEveryUpdate) {
  const Tour run(Particles(4));
  for (int i = 0; i < 4; ++i) {
    const std::vector<SE2> path = run.filter.Path(i);
    ASSERT_EQ(path.size(), run.updates.size() + 1);
    EXPECT_TRUE((path.front() == SE2{}));
    EXPECT_TRUE(path.back() == run.filter.particles()[i].world_T_robot);
  }
}

TEST(ParticleFilter, TracksARobotInARoomWithFiveParticles) {
  const std::vector<SE2> truth = Drive();
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Tour run(Particles(5, 1, seed));
    const std::vector<SE2> path = run.filter.Path(run.filter.BestParticle());
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
    for (const ParticleFilter::Update& update : run.updates) EXPECT_EQ(update.failed_matches, 0);
  }
}

class OneStep : public testing::Test {
 protected:
  explicit OneStep(double resample_threshold = 1.1) {  // above 1: after every step
    ParticleFilter::Options options = Particles(8);
    options.resample_threshold = resample_threshold;
    options.obs_sigma_gain = 0.05;  // so that weights differ enough for twins
    filter_ = std::make_unique<ParticleFilter>(
        options, std::make_shared<scan_matching::HillClimbing>(
                     scan_matching::HillClimbing::Options{}, options.endpoint));
    filter_->Start(synthetic::Scan(synthetic::Room(), {}), {});
  }
  ParticleFilter::Update Step(const SE2& truth, const SE2& increment) {
    return filter_->Advance(synthetic::Scan(synthetic::Room(), truth), increment);
  }
  std::unique_ptr<ParticleFilter> filter_;
};

TEST_F(OneStep, StartSharesOneMap) {
  for (const Particle& particle : filter_->particles()) {
    EXPECT_GT(particle.map.CountTiles(), 20u);
    EXPECT_EQ(particle.map.CountOwnTiles(), 0u);
  }
}

TEST_F(OneStep, TwinsShareAllTilesAfterResampling) {
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

TEST_F(OneStep, FailedMatchFallsBackToTheMotionModel) {
  sensor::LaserScan blind;  // no beams: nothing to match
  const ParticleFilter::Update update = filter_->Advance(blind, {1.0, 0.0, 0.0});
  EXPECT_EQ(update.failed_matches, 8);
  EXPECT_NEAR(update.effective_sample_size, 8.0, 1e-9);
  const Eigen::Matrix3d covariance = MotionModel({}).Covariance({}, {1, 0, 0});
  for (const Particle& particle : filter_->particles()) {
    EXPECT_FALSE(particle.step.matched);
    EXPECT_TRUE(particle.step.world_covariance == covariance);
    EXPECT_TRUE((particle.step.world_T_previous == SE2{}));
    EXPECT_LT(std::abs(particle.world_T_robot.x - 1.0), 4.0 * std::sqrt(covariance(0, 0)));
  }
  EXPECT_FALSE(filter_->particles()[0].world_T_robot == filter_->particles()[1].world_T_robot);
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
