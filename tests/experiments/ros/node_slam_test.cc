// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/node_slam.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gmapping_spa::ros {
namespace {

TEST(EntropyOfWeights, IsThatOfTheirNumberWhereTheyAreAlike) {
  EXPECT_NEAR(EntropyOfWeights({-5.0, -5.0, -5.0, -5.0}, 0.3), std::log(4.0), 1e-12);
}

TEST(EntropyOfWeights, IsZeroWhereOneParticleHasItAll) {
  EXPECT_NEAR(EntropyOfWeights({0.0, -1e4}, 1.0), 0.0, 1e-12);
}

TEST(EntropyOfWeights, TakesTheGainIntoAccount) {
  // exp(0.5 * log 9) : 1 is 3 : 1.
  const double expected = -0.75 * std::log(0.75) - 0.25 * std::log(0.25);
  EXPECT_NEAR(EntropyOfWeights({std::log(9.0), 0.0}, 0.5), expected, 1e-12);
}

}  // namespace
}  // namespace gmapping_spa::ros
