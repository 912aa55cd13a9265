// SPDX-License-Identifier: BSD-3-Clause
// What a back end does to the particles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "frontend/particle_filter/particle_filter.h"
#include "tests/frontend/particle_filter/tour.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;
using Vertex = TrajectoryTree::Vertex;

// As an optimizer would: bends the best path, the more the later, and turns it as well.
PathCorrection Bend(const ParticleFilter& filter) {
  PathCorrection correction{PosesOf(filter.Path(filter.BestParticle())), {}};
  for (std::size_t k = 0; k < correction.before.size(); ++k) {
    const double d = static_cast<double>(k);
    correction.after.push_back(SE2{0.02 * d, -0.01 * d, 0.008 * d} * correction.before[k]);
  }
  return correction;
}

// The state of a filter, to be compared with a later one.
struct State {
  explicit State(const ParticleFilter& filter)
      : particles(filter.particles()), best(filter.BestParticle()) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      paths.push_back(filter.Path(static_cast<int>(i)));
    }
  }

  // Number of poses that two particles share.
  int Shared(std::size_t i, std::size_t j) const {
    int shared = 0;
    while (shared < static_cast<int>(std::min(paths[i].size(), paths[j].size())) &&
           paths[i][shared].world_T_robot == paths[j][shared].world_T_robot) {
      ++shared;
    }
    return shared;
  }

  std::vector<Particle> particles;
  int best;
  std::vector<std::vector<Vertex>> paths;
};

bool SameMotion(const TrajectoryTree::Motion& a, const TrajectoryTree::Motion& b) {
  return a.previous_T_robot == b.previous_T_robot && a.information == b.information &&
         a.matched == b.matched;
}

void ExpectSameWeightsAndMotions(const State& a, const State& b) {
  ASSERT_EQ(a.particles.size(), b.particles.size());
  EXPECT_EQ(a.best, b.best);
  for (std::size_t i = 0; i < a.particles.size(); ++i) {
    EXPECT_EQ(a.particles[i].log_weight, b.particles[i].log_weight);
    EXPECT_EQ(a.particles[i].log_likelihood, b.particles[i].log_likelihood);
    EXPECT_TRUE(SameMotion(a.particles[i].motion, b.particles[i].motion));
    ASSERT_EQ(a.paths[i].size(), b.paths[i].size());
    for (std::size_t k = 1; k < a.paths[i].size(); ++k) {
      EXPECT_TRUE(SameMotion(a.paths[i][k].motion, b.paths[i][k].motion)) << k;
    }
  }
}

ParticleFilter::Options Resampling(double threshold) {
  ParticleFilter::Options options = Particles(6);
  options.resample_threshold = threshold;
  options.obs_sigma_gain = 0.01;  // so that weights differ enough for twins
  options.map_history.snapshot_every = 3;
  return options;
}

// Thresholds: never, sometimes and after every step, when twins share leaves.
class Correction : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(ResampleThreshold, Correction, testing::Values(0.0, 0.5, 1.1));

TEST_P(Correction, OfCurrentPosesMovesNothingElse) {
  Tour tour(Resampling(GetParam()), 8);
  const State before(tour.filter);
  const PathCorrection correction = Bend(tour.filter);
  tour.filter.CorrectCurrentPoses(correction);
  const State after(tour.filter);
  ExpectSameWeightsAndMotions(before, after);
  for (std::size_t i = 0; i < before.particles.size(); ++i) {
    const SE2 moved = correction.Apply(8, before.particles[i].world_T_robot);
    EXPECT_FALSE(moved == before.particles[i].world_T_robot);
    EXPECT_TRUE(after.particles[i].world_T_robot == moved);
    EXPECT_TRUE(after.paths[i].back().world_T_robot == moved);
    for (int k = 0; k < 8; ++k) {
      EXPECT_TRUE(after.paths[i][k].world_T_robot == before.paths[i][k].world_T_robot) << k;
    }
    EXPECT_TRUE(SameMap(after.particles[i].map, before.particles[i].map));
  }
}

TEST_P(Correction, OfHistoriesMovesEveryPoseAndRebuildsTheMaps) {
  Tour tour(Resampling(GetParam()), 8);
  const State before(tour.filter);
  const PathCorrection correction = Bend(tour.filter);
  tour.filter.CorrectHistories(correction, ScanOnDrive);
  const State after(tour.filter);
  ExpectSameWeightsAndMotions(before, after);
  for (std::size_t i = 0; i < before.particles.size(); ++i) {
    for (int k = 0; k <= 8; ++k) {
      const SE2 moved = correction.Apply(k, before.paths[i][k].world_T_robot);
      EXPECT_TRUE(after.paths[i][k].world_T_robot == moved) << k;
    }
    EXPECT_TRUE(after.particles[i].world_T_robot == after.paths[i].back().world_T_robot);
    EXPECT_TRUE(
        SameMap(after.particles[i].map, MapFromScratch(PosesOf(after.paths[i]), ScanOnDrive)));
    EXPECT_FALSE(SameMap(after.particles[i].map, before.particles[i].map));
  }
}

TEST_P(Correction, OfHistoriesKeepsAncestry) {
  Tour tour(Resampling(GetParam()), 8);
  const State before(tour.filter);
  tour.filter.CorrectHistories(Bend(tour.filter), ScanOnDrive);
  const State after(tour.filter);
  for (std::size_t i = 1; i < before.particles.size(); ++i) {
    EXPECT_EQ(after.Shared(0, i), before.Shared(0, i)) << i;
    EXPECT_EQ(after.particles[i].leaf == after.particles[i - 1].leaf,
              before.particles[i].leaf == before.particles[i - 1].leaf);
  }
}

TEST_P(Correction, WithoutADifferenceRebuildsTheMapsThatTheFilterHas) {
  Tour tour(Resampling(GetParam()), 8);
  const State before(tour.filter);
  // Of the first poses only, which do not move: exact, as no other choice of `before` would be.
  tour.filter.CorrectHistories({{SE2{}}, {SE2{}}}, ScanOnDrive);
  const State after(tour.filter);
  for (std::size_t i = 0; i < before.particles.size(); ++i) {
    EXPECT_EQ(PosesOf(after.paths[i]), PosesOf(before.paths[i]));
    EXPECT_TRUE(SameMap(after.particles[i].map, before.particles[i].map));
  }
}

TEST_P(Correction, MayBeRepeated) {
  Tour tour(Resampling(GetParam()), 4);
  for (const int steps : {5, 3, 0, 6}) {
    tour.filter.CorrectHistories(Bend(tour.filter), ScanOnDrive);
    tour.Continue(steps);
  }
  tour.filter.CorrectHistories(Bend(tour.filter), ScanOnDrive);
  const State state(tour.filter);
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    ASSERT_EQ(state.paths[i].size(), 19u);
    EXPECT_TRUE(
        SameMap(state.particles[i].map, MapFromScratch(PosesOf(state.paths[i]), ScanOnDrive)));
  }
}

TEST(ParticleFilterCorrection, TwinsOccurInTheCasesAbove) {
  const Tour tour(Resampling(1.1), 8);
  const std::vector<Particle>& particles = tour.filter.particles();
  const auto twins =
      std::adjacent_find(particles.begin(), particles.end(),
                         [](const Particle& a, const Particle& b) { return a.leaf == b.leaf; });
  EXPECT_NE(twins, particles.end());
}

TEST(ParticleFilterCorrection, StepsThatTheCorrectionDoesNotReachMoveWithItsLast) {
  for (const bool histories : {false, true}) {
    Tour tour(Particles(3), 8);
    PathCorrection correction = Bend(tour.filter);
    correction.before.resize(6);
    correction.after.resize(6);
    const SE2 current = tour.filter.particles()[1].world_T_robot;
    if (histories) {
      tour.filter.CorrectHistories(correction, ScanOnDrive);
    } else {
      tour.filter.CorrectCurrentPoses(correction);
    }
    EXPECT_TRUE(tour.filter.particles()[1].world_T_robot == correction.Apply(5, current));
  }
}

TEST(ParticleFilterCorrection, FilterTracksTheRobotInTheCorrectedWorld) {
  // The whole path moves as one piece: so must all that comes later.
  const SE2 corrected_T_world{2.0, -1.0, 0.7};
  Tour tour(Particles(5), 10);
  PathCorrection correction{PosesOf(tour.filter.Path(0)), {}};
  for (const SE2& pose : correction.before) correction.after.push_back(corrected_T_world * pose);
  tour.filter.CorrectHistories(correction, ScanOnDrive);
  tour.Continue(10);
  const std::vector<SE2> truth = Drive();
  const std::vector<SE2> path = PosesOf(tour.filter.Path(tour.filter.BestParticle()));
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const SE2 error = Between(corrected_T_world * truth[k], path[k]);
    EXPECT_LT(error.translation().norm(), 0.06) << k;
    EXPECT_LT(std::abs(error.theta), 0.02) << k;
  }
  EXPECT_GT(tour.filter.times().correction_s, 0.0);
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
