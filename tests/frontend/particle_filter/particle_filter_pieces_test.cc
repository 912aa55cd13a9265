// SPDX-License-Identifier: BSD-3-Clause
// A filter that goes on where nothing is known of the motion.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <memory>
#include <vector>

#include "frontend/map/scan_insertion.h"
#include "frontend/particle_filter/particle_filter.h"
#include "frontend/scan_matching/hill_climbing.h"
#include "tests/frontend/particle_filter/same_map.h"
#include "tests/frontend/synthetic_room.h"

namespace gmapping_spa::particle_filter {
namespace {

using backend::SE2;

class NewPiece : public testing::Test {
 protected:
  NewPiece() {
    options_.particles = 3;
    filter_ = std::make_unique<ParticleFilter>(
        options_, std::make_shared<scan_matching::HillClimbing>(
                      scan_matching::HillClimbing::Options{}, options_.endpoint));
    filter_->Start(ScanAt({}), {});
    filter_->Update(ScanAt({0.5, 0, 0}), {{.motion = {0.5, 0, 0}}});
    for (const Particle& particle : filter_->particles()) before_.push_back(particle.world_T_robot);
    filter_->BeginPiece(ScanAt({-1, 1, 2}), kGuess);
  }

  static sensor::LaserScan ScanAt(const SE2& pose) {
    return synthetic::Scan(synthetic::Room(), pose);
  }

  static inline const SE2 kGuess{0.4, 0.1, 0.2};
  ParticleFilter::Options options_;
  std::unique_ptr<ParticleFilter> filter_;
  std::vector<SE2> before_;
};

TEST_F(NewPiece, GoesOnFromTheGuess) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(filter_->particles()[k].world_T_robot == before_[k] * kGuess);
    ASSERT_EQ(filter_->Path(k).size(), 3u);
    EXPECT_TRUE(filter_->Path(k)[1].world_T_robot == before_[k]);
  }
}

TEST_F(NewPiece, HoldsItsOwnScansOnly) {
  for (const Particle& particle : filter_->particles()) {
    map::OccupancyGrid fresh(options_.grid);
    map::InsertScan(ScanAt({-1, 1, 2}), particle.world_T_robot, options_.insertion, &fresh);
    EXPECT_TRUE(SameMap(particle.map, fresh));
  }
}

TEST_F(NewPiece, SaysNextToNothingOfTheMotion) {
  const TrajectoryTree::Motion motion = filter_->Path(0).back().motion;
  EXPECT_FALSE(motion.matched);
  EXPECT_TRUE(motion.previous_T_robot == kGuess);
  EXPECT_LT(motion.information.norm(), 1e-3);
  EXPECT_EQ(motion.information.llt().info(), Eigen::Success);
}

TEST_F(NewPiece, MapsAreRebuiltOfTheScansThatAreGivenThen) {
  PathCorrection correction;
  for (const TrajectoryTree::Vertex& vertex : filter_->Path(0)) {
    correction.before.push_back(vertex.world_T_robot);
  }
  correction.after = correction.before;
  int asked = 0;
  const auto nothing = [&asked](int) {
    ++asked;
    return sensor::LaserScan{};
  };
  filter_->CorrectHistories(correction, nothing);
  filter_->ForgetMapHistory();
  filter_->CorrectHistories(correction, nothing);
  EXPECT_GE(asked, 6);
  EXPECT_TRUE(SameMap(filter_->particles()[0].map, map::OccupancyGrid(options_.grid)));
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
