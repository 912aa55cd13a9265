// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/score_peak.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "frontend/scan_matching/field_pyramid.h"
#include "frontend/scan_matching/likelihood_field.h"

namespace gmapping_spa::scan_matching::score_peak_test {
namespace {

constexpr double kResolution = 0.05, kAngularStep = 0.04;
constexpr double kSeparation_m = 0.21, kSeparation_rad = 0.1;
constexpr PoseBlock kBest{.level = 0, .angle = 1, .x = -2, .y = 3, .bound = 0};

// A lattice around the match of three points with themselves.
class ScorePeakTest : public ::testing::Test {
 protected:
  // By the definition, pose by pose.
  static bool Holds(int angle, int x, int y) {
    return std::hypot(x - kBest.x, y - kBest.y) * kResolution <= kSeparation_m &&
           std::abs(angle - kBest.angle) * kAngularStep <= kSeparation_rad;
  }

  const std::vector<Eigen::Vector2d> points_ = {{1.025, 0.025}, {0.025, 1.025}, {-0.475, -0.475}};
  const ByteGrid field_ = MakeLikelihoodField({.resolution_m = kResolution}, points_);
  const FieldPyramid pyramid_{field_, 3};
  const PoseLattice lattice_{
      {{0.0, 0.0, 0.0}, kResolution, kAngularStep, 8, 8}, &pyramid_, points_};
};

TEST_F(ScorePeakTest, HoldsBlocksAsTheirPosesSay) {
  const ScorePeak peak(&lattice_, kBest, kSeparation_m, kSeparation_rad);
  int all_blocks = 0, some_blocks = 0, outside_blocks = 0;
  for (int level = 0; level < 3; ++level) {
    const int size = 1 << level;
    for (int angle = -8; angle <= 8; ++angle) {
      for (int x = -8; x <= 8; ++x) {
        for (int y = -8; y <= 8; ++y) {
          int held = 0;
          for (int i = 0; i < size * size * size; ++i) {
            held += Holds(angle + i / (size * size), x + i / size % size, y + i % size);
          }
          const PoseBlock block{.level = level, .angle = angle, .x = x, .y = y};
          const bool all = held == size * size * size, some = held > 0;
          ASSERT_EQ(peak.HoldsAllOf(block), all) << level << ' ' << angle << ' ' << x << ' ' << y;
          ASSERT_EQ(peak.HoldsSomeOf(block), some) << level << ' ' << angle << ' ' << x << ' ' << y;
          ++(all ? all_blocks : some ? some_blocks : outside_blocks);
        }
      }
    }
  }
  EXPECT_GT(all_blocks, 100);
  EXPECT_GT(some_blocks, 100);
  EXPECT_GT(outside_blocks, 100);
}

TEST_F(ScorePeakTest, CovarianceIsThatOfRoundingAndGrowsAsOtherPosesCount) {
  PoseBlock best{.level = 1};
  lattice_.ForEachPart({.level = 1, .angle = 0, .x = 0, .y = 0}, [&](const PoseBlock& part) {
    if (part.angle == 0 && part.x == 0 && part.y == 0) best = part;
  });
  ASSERT_EQ(best.level, 0);
  const ScorePeak peak(&lattice_, best, kSeparation_m, kSeparation_rad);
  // An angular step leaves the points in their cells, a linear one does not.
  const Eigen::Vector3d alone = peak.Covariance(/*log_weight_per_sum=*/1e3).diagonal();
  EXPECT_NEAR(alone.x(), kResolution * kResolution / 12.0, 1e-12);
  EXPECT_NEAR(alone.y(), kResolution * kResolution / 12.0, 1e-12);
  EXPECT_GE(alone.z(), kAngularStep * kAngularStep / 12.0);
  // The less a difference of scores weighs, the more poses have a part in the peak.
  const Eigen::Vector3d narrow = peak.Covariance(0.1).diagonal();
  const Eigen::Vector3d wide = peak.Covariance(0.01).diagonal();
  EXPECT_TRUE((wide.array() > narrow.array()).all()) << wide << "\n\n" << narrow;
}

}  // namespace
}  // namespace gmapping_spa::scan_matching::score_peak_test
