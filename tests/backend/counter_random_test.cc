// SPDX-License-Identifier: BSD-3-Clause
#include "backend/counter_random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gmapping_spa::backend {
namespace {

constexpr int kDraws = 200000;
// Seeds are fixed: five standard errors are far from any honest generator's luck.
constexpr double kStandardErrors = 5.0;

TEST(CounterRandom, GivesTheKnownAnswerOfPhilox) {
  // Philox4x32-10 with counter 0 and key 0 starts 6627e8d5 e169c58d (kat_vectors of Random123).
  const double expected = std::ldexp(static_cast<double>(0xe169c58d6627e8d5ULL >> 12), -52);
  EXPECT_NEAR(CounterRandom(0, 0).Uniform(), expected, std::ldexp(1.0, -52));
}

TEST(CounterRandom, SameAddressGivesSameDraws) {
  CounterRandom first(42, 1, 2, 3), second(42, 1, 2, 3);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(first.Uniform(), second.Uniform());
    EXPECT_EQ(first.Gaussian(), second.Gaussian());
  }
}

TEST(CounterRandom, EveryPartOfTheAddressMatters) {
  const double reference = CounterRandom(42, 1, 2, 3).Uniform();
  EXPECT_NE(CounterRandom(43, 1, 2, 3).Uniform(), reference);
  EXPECT_NE(CounterRandom(42 + (1ULL << 32), 1, 2, 3).Uniform(), reference);
  EXPECT_NE(CounterRandom(42, 2, 2, 3).Uniform(), reference);
  EXPECT_NE(CounterRandom(42, 1, 3, 3).Uniform(), reference);
  EXPECT_NE(CounterRandom(42, 1, 2, 4).Uniform(), reference);
}

TEST(CounterRandom, UniformHasTheMomentsOfTheUnitInterval) {
  CounterRandom random(7, 0);
  double sum = 0.0, sum_squares = 0.0, low = 1.0, high = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.Uniform();
    sum += u;
    sum_squares += u * u;
    low = std::min(low, u);
    high = std::max(high, u);
  }
  EXPECT_GT(low, 0.0);
  EXPECT_LT(high, 1.0);
  EXPECT_LT(low, 1e-4);
  EXPECT_GT(high, 1.0 - 1e-4);
  EXPECT_NEAR(sum / kDraws, 0.5, kStandardErrors * std::sqrt(1.0 / 12.0 / kDraws));
  EXPECT_NEAR(sum_squares / kDraws, 1.0 / 3.0, kStandardErrors * std::sqrt(4.0 / 45.0 / kDraws));
}

TEST(CounterRandom, GaussianHasTheMomentsOfTheStandardNormal) {
  CounterRandom random(7, 0);
  double sum = 0.0, sum_squares = 0.0, sum_fourth = 0.0, sum_neighbors = 0.0, previous = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double g = random.Gaussian();
    sum += g;
    sum_squares += g * g;
    sum_fourth += g * g * g * g;
    sum_neighbors += g * previous;
    previous = g;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, kStandardErrors * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(sum_squares / kDraws, 1.0, kStandardErrors * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(sum_fourth / kDraws, 3.0, kStandardErrors * std::sqrt(96.0 / kDraws));
  EXPECT_NEAR(sum_neighbors / kDraws, 0.0, kStandardErrors * std::sqrt(1.0 / kDraws));
}

TEST(CounterRandom, NeighboringAddressesAreUncorrelated) {
  double streams = 0.0, scans = 0.0, particles = 0.0, seeds = 0.0;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const double here = CounterRandom(7, 1, i, 5).Gaussian();
    streams += here * CounterRandom(7, 2, i, 5).Gaussian();
    scans += here * CounterRandom(7, 1, i + 1, 5).Gaussian();
    particles += here * CounterRandom(7, 1, i, 6).Gaussian();
    seeds += here * CounterRandom(8, 1, i, 5).Gaussian();
  }
  const double tolerance = kStandardErrors * std::sqrt(1.0 / kDraws);
  EXPECT_NEAR(streams / kDraws, 0.0, tolerance);
  EXPECT_NEAR(scans / kDraws, 0.0, tolerance);
  EXPECT_NEAR(particles / kDraws, 0.0, tolerance);
  EXPECT_NEAR(seeds / kDraws, 0.0, tolerance);
}

}  // namespace
}  // namespace gmapping_spa::backend
