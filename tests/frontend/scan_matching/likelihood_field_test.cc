// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/scan_matching/likelihood_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "backend/counter_random.h"

namespace gmapping_spa::scan_matching {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(LikelihoodField, IsTheGaussianOfTheDistanceToTheNearestPointEverywhere) {
  const LikelihoodFieldOptions options{.resolution_m = 0.07, .sigma_m = 0.15};
  backend::CounterRandom random(1, 0);
  Points points;
  for (int i = 0; i < 20; ++i) points.push_back({3.0 * random.Uniform() - 2.0, random.Uniform()});
  const ByteGrid field = MakeLikelihoodField(options, points);
  for (int y = -60; y <= 60; ++y) {
    for (int x = -60; x <= 60; ++x) {
      const Eigen::Vector2d middle = 0.07 * Eigen::Vector2d(x + 0.5, y + 0.5);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Eigen::Vector2d& point : points) {
        nearest = std::min(nearest, (point - middle).squaredNorm());
      }
      const double expected = 255.0 * std::exp(-nearest / (2.0 * 0.15 * 0.15));
      EXPECT_NEAR(field.value({x, y}), expected, 0.5001) << x << ' ' << y;
    }
  }
}

TEST(LikelihoodField, IsFullAtAPointInTheMiddleOfACell) {
  const ByteGrid field = MakeLikelihoodField({}, {{-0.975, 2.025}});
  EXPECT_EQ(field.value({-20, 40}), 255);
  EXPECT_EQ(field.value({-18, 40}), std::lround(255.0 * std::exp(-0.5)));
  EXPECT_EQ(field.value({-20, 38}), std::lround(255.0 * std::exp(-0.5)));
}

TEST(LikelihoodField, IsZeroOutsideOnAllSidesHoweverFar) {
  const ByteGrid field = MakeLikelihoodField({}, {{0.025, 0.025}});
  for (const int far : {20, 1000, 1 << 20, std::numeric_limits<int>::max() / 2}) {
    for (const map::CellIndex cell :
         {map::CellIndex{far, 0}, {-far, 0}, {0, far}, {0, -far}, {far, -far}}) {
      EXPECT_EQ(field.value(cell), 0);
    }
  }
}

TEST(LikelihoodField, IsZeroWithoutPoints) {
  EXPECT_EQ(MakeLikelihoodField({}, {}).value({0, 0}), 0);
}

}  // namespace
}  // namespace gmapping_spa::scan_matching
