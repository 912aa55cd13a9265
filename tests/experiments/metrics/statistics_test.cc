// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace gmapping_spa::metrics {
namespace {

TEST(Statistics, OfFourErrorsByHand) {
  const Statistics s = ComputeStatistics({4.0, 1.0, 3.0, 8.0});
  EXPECT_DOUBLE_EQ(s.mean, 4.0);
  EXPECT_DOUBLE_EQ(s.median, 3.5);
  EXPECT_DOUBLE_EQ(s.std, std::sqrt((0.0 + 9.0 + 1.0 + 16.0) / 4.0));
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt((16.0 + 1.0 + 9.0 + 64.0) / 4.0));
  EXPECT_DOUBLE_EQ(s.min, 1.0);
  EXPECT_DOUBLE_EQ(s.max, 8.0);
}

TEST(Statistics, TheMedianOfAnOddNumberIsTheMiddleOne) {
  EXPECT_DOUBLE_EQ(ComputeStatistics({9.0, 1.0, 2.0}).median, 2.0);
}

TEST(Statistics, ASmallSpreadOfLargeErrorsIsKept) {
  EXPECT_NEAR(ComputeStatistics({1e9 + 1.0, 1e9 - 1.0}).std, 1.0, 1e-6);
}

TEST(Statistics, OfNothingAreAnError) {
  EXPECT_THROW(ComputeStatistics({}), std::invalid_argument);
}

TEST(MeanAndP95, IsNotExceededByNineteenOfTwenty) {
  std::vector<double> errors;
  for (int i = 40; i > 0; --i) errors.push_back(i);
  EXPECT_DOUBLE_EQ(ComputeMeanAndP95(errors)->mean, 20.5);
  EXPECT_DOUBLE_EQ(ComputeMeanAndP95(errors)->p95, 38.0);
  EXPECT_DOUBLE_EQ(ComputeMeanAndP95({3.0, 1.0})->p95, 3.0);
  EXPECT_FALSE(ComputeMeanAndP95({}));
}

}  // namespace
}  // namespace gmapping_spa::metrics
