// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/map/tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "backend/counter_random.h"

namespace gmapping_spa::map {
namespace {

// Largest distance between the running mean and the exact one, in cells, over `count` hits whose
// coordinates are spread evenly over the cell.
double WorstErrorOfMean(int count, std::uint64_t seed) {
  backend::CounterRandom random(seed, 0);
  Cell cell;
  double sum_x = 0.0, sum_y = 0.0, worst = 0.0;
  for (int i = 1; i <= count; ++i) {
    const auto x = static_cast<std::uint16_t>(random.Uniform() * Cell::kMeanScale);
    const auto y = static_cast<std::uint16_t>(random.Uniform() * Cell::kMeanScale);
    cell.AddHit(x, y);
    sum_x += x;
    sum_y += y;
    worst = std::max(worst, std::abs(cell.mean_x - sum_x / i) / Cell::kMeanScale);
    worst = std::max(worst, std::abs(cell.mean_y - sum_y / i) / Cell::kMeanScale);
  }
  return worst;
}

TEST(Cell, CountsHitsAsVisits) {
  Cell cell;
  cell.AddPass();
  cell.AddHit(1, 2);
  cell.AddPass();
  EXPECT_EQ(cell.visits, 3);
  EXPECT_EQ(cell.hits, 1);
}

TEST(Cell, MeanOfOneHitIsTheHit) {
  for (const std::uint16_t x : {0, 1, 32768, 65535}) {
    Cell cell;
    cell.AddHit(x, static_cast<std::uint16_t>(65535 - x));
    EXPECT_EQ(cell.mean_x, x);
    EXPECT_EQ(cell.mean_y, 65535 - x);
  }
}

TEST(Cell, MeanOfEqualHitsStaysThere) {
  Cell cell;
  for (int i = 0; i < 70000; ++i) cell.AddHit(12345, 65535);
  EXPECT_EQ(cell.mean_x, 12345);
  EXPECT_EQ(cell.mean_y, 65535);
}

TEST(Cell, RunningMeanFollowsTheExactMean) {
  // Rounding to a 65536th with each of so many hits must not add up.
  for (const std::uint64_t seed : {1, 2, 3}) EXPECT_LT(WorstErrorOfMean(2000, seed), 0.002);
}

TEST(Cell, MeanOfLopsidedHitsFollowsTheExactMean) {
  // One hit in ten at the far end: the small steps to one side must not be rounded away while the
  // large ones to the other side are taken.
  Cell cell;
  double sum = 0.0;
  constexpr int kHits = 5000;
  for (int i = 0; i < kHits; ++i) {
    const std::uint16_t x = i % 10 == 9 ? 65535 : 0;
    cell.AddHit(x, x);
    sum += x;
  }
  EXPECT_NEAR(cell.mean_x, sum / kHits, 0.01 * Cell::kMeanScale);
}

TEST(Cell, SaturatedCountersKeepTheirRatio) {
  Cell cell;
  double worst = 0.0;
  for (int i = 0; i < 400000; ++i) {
    if (i % 4 == 0) {
      cell.AddHit(100, 200);
    } else {
      cell.AddPass();
    }
    if (i > 1000)
      worst = std::max(worst, std::abs(cell.hits / static_cast<double>(cell.visits) - 0.25));
  }
  EXPECT_LT(worst, 1e-3);
  EXPECT_GT(cell.visits, 30000);
}

TEST(Cell, SaturatedCountersGoOnLearning) {
  Cell cell;
  for (int i = 0; i < 65535; ++i) cell.AddHit(0, 0);
  for (int i = 0; i < 400000; ++i) cell.AddPass();
  EXPECT_LT(cell.hits, 0.01 * cell.visits);
}

}  // namespace
}  // namespace gmapping_spa::map
