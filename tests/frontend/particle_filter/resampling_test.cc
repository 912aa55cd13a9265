// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/resampling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "backend/counter_random.h"

namespace gmapping_spa::particle_filter {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

std::vector<double> RandomWeights(int count, backend::CounterRandom* random) {
  std::vector<double> log_weights;
  for (int i = 0; i < count; ++i) log_weights.push_back(3.0 * random->Gaussian());
  return NormalizedWeights(log_weights, 1.0);
}

std::vector<int> Counts(const std::vector<int>& ancestors) {
  std::vector<int> counts(ancestors.size());
  for (const int ancestor : ancestors) ++counts[ancestor];
  return counts;
}

TEST(NormalizedWeights, AreTheExponentialsOfTheirLogarithms) {
  EXPECT_THAT(NormalizedWeights({std::log(1.0), std::log(2.0), std::log(5.0)}, 1.0),
              ElementsAre(DoubleNear(1 / 8.0, 1e-12), DoubleNear(2 / 8.0, 1e-12),
                          DoubleNear(5 / 8.0, 1e-12)));
}

TEST(NormalizedWeights, GainFlattensThem) {
  EXPECT_THAT(NormalizedWeights({std::log(1.0), std::log(9.0)}, 0.5),
              ElementsAre(DoubleNear(0.25, 1e-12), DoubleNear(0.75, 1e-12)));
}

TEST(NormalizedWeights, NeitherOverflowNorVanish) {
  for (const double shift : {-1e9, -1e4, 1e4, 1e9}) {
    EXPECT_THAT(NormalizedWeights({shift, shift, shift - 1e6}, 1.0),
                ElementsAre(0.5, 0.5, DoubleNear(0.0, 1e-300)));
  }
}

TEST(EffectiveSampleSize, IsTheNumberOfEqualWeights) {
  for (const int count : {1, 2, 30}) {
    EXPECT_NEAR(EffectiveSampleSize(std::vector<double>(count, 1.0 / count)), count, 1e-9);
  }
  EXPECT_NEAR(EffectiveSampleSize({0.5, 0.0, 0.5, 0.0}), 2.0, 1e-12);
}

TEST(EffectiveSampleSize, IsOneWhenOneParticleHasAllTheWeight) {
  EXPECT_EQ(EffectiveSampleSize({0.0, 1.0, 0.0}), 1.0);
}

TEST(SystematicResample, TakesEachParticleAsOftenAsItsWeightRoundedUpOrDown) {
  backend::CounterRandom random(1, 0);
  for (int trial = 0; trial < 2000; ++trial) {
    const int count = 1 + static_cast<int>(40 * random.Uniform());
    const std::vector<double> weights = RandomWeights(count, &random);
    const std::vector<int> ancestors = SystematicResample(weights, count, random.Uniform());
    ASSERT_EQ(ancestors.size(), weights.size());
    ASSERT_TRUE(std::is_sorted(ancestors.begin(), ancestors.end()));
    const std::vector<int> counts = Counts(ancestors);
    for (int i = 0; i < count; ++i) {
      ASSERT_GE(counts[i], std::floor(count * weights[i] - 1e-9));
      ASSERT_LE(counts[i], std::ceil(count * weights[i] + 1e-9));
    }
  }
}

TEST(SystematicResample, TakesEachParticleAsOftenAsItsWeightOnAverage) {
  backend::CounterRandom random(2, 0);
  constexpr int kCount = 12, kUniforms = 5000;
  for (int trial = 0; trial < 5; ++trial) {
    const std::vector<double> weights = RandomWeights(kCount, &random);
    std::vector<double> sums(kCount);
    for (int k = 0; k < kUniforms; ++k) {
      const std::vector<int> counts =
          Counts(SystematicResample(weights, kCount, (k + 0.5) / kUniforms));
      for (int i = 0; i < kCount; ++i) sums[i] += counts[i];
    }
    // Over evenly spread numbers the mean is off by one of them at most.
    for (int i = 0; i < kCount; ++i) {
      EXPECT_NEAR(sums[i] / kUniforms, kCount * weights[i], 2.0 / kUniforms) << i;
    }
  }
}

TEST(SystematicResample, KeepsEverybodyWhenAllAreEqual) {
  for (const double uniform : {0.0, 0.3, 0.999}) {
    EXPECT_THAT(SystematicResample(std::vector<double>(4, 0.25), 4, uniform),
                ElementsAre(0, 1, 2, 3));
  }
}

TEST(SystematicResample, TakesTheOnlyOneThatHasWeight) {
  EXPECT_THAT(SystematicResample({0, 0, 1, 0}, 4, 0.0), ElementsAre(2, 2, 2, 2));
  EXPECT_THAT(SystematicResample({1, 0, 0, 0}, 4, 0.999), ElementsAre(0, 0, 0, 0));
}

TEST(SystematicResample, FillsUpWhenTheWeightsSumToALittleLessThanOne) {
  EXPECT_THAT(SystematicResample({0.5, 0.5 - 1e-12}, 2, 1.0 - 1e-13), ElementsAre(0, 1));
}

TEST(SystematicResample, SharesOutMoreOrFewerDrawsThanThereAreWeights) {
  EXPECT_THAT(SystematicResample({0.6, 0.4}, 5, 0.5), ElementsAre(0, 0, 0, 1, 1));
  EXPECT_THAT(SystematicResample({0.3, 0.3, 0.2, 0.2}, 2, 0.5), ElementsAre(0, 2));
  // In the middle of the likeliest, if that comes first.
  EXPECT_THAT(SystematicResample({0.51, 0.49}, 1, 0.5), ElementsAre(0));
}

}  // namespace
}  // namespace gmapping_spa::particle_filter
