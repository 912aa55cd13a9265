// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace gmapping_spa::loop_closure {
namespace {

using backend::SE2;

backend::Edge Closure(int i, int j) {
  backend::Edge edge;
  edge.i = i;
  edge.j = j;
  edge.kind = backend::EdgeKind::kLoopClosure;
  return edge;
}

// All shortest ways by Floyd and Warshall, from a matrix of the direct ones.
std::vector<std::vector<double>> AllShortestWays(const std::vector<double>& ways_driven,
                                                 const std::vector<backend::Edge>& closures) {
  const std::size_t n = ways_driven.size();
  std::vector<std::vector<double>> ways(
      n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (std::size_t k = 0; k < n; ++k) {
    ways[k][k] = 0.0;
    if (k > 0) ways[k][k - 1] = ways[k - 1][k] = ways_driven[k] - ways_driven[k - 1];
  }
  for (const backend::Edge& closure : closures) {
    ways[closure.i][closure.j] = ways[closure.j][closure.i] = 0.0;
  }
  for (std::size_t via = 0; via < n; ++via) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        ways[i][j] = std::min(ways[i][j], ways[i][via] + ways[via][j]);
      }
    }
  }
  return ways;
}

TEST(DriftModel, SigmasGrowWithTheWayFromAFloor) {
  const DriftModel drift{.floor_m = 0.2, .m_per_m = 0.02, .floor_rad = 0.03, .rad_per_m = 0.001};
  EXPECT_DOUBLE_EQ(drift.LinearSigma(0), 0.2);
  EXPECT_DOUBLE_EQ(drift.LinearSigma(50), 1.2);
  EXPECT_DOUBLE_EQ(drift.AngularSigma(0), 0.03);
  EXPECT_DOUBLE_EQ(drift.AngularSigma(50), 0.08);
}

TEST(DriftModel, SquaredDistanceIsInStandardDeviations) {
  const DriftModel drift;
  const double m = drift.LinearSigma(30), rad = drift.AngularSigma(30);
  EXPECT_NEAR(drift.SquaredDistance({2 * m, 0, 0}, 30), 4.0, 1e-12);
  EXPECT_NEAR(drift.SquaredDistance({0, -m, 0}, 30), 1.0, 1e-12);
  EXPECT_NEAR(drift.SquaredDistance({0.6 * m, 0.8 * m, -3 * rad}, 30), 10.0, 1e-12);
  EXPECT_LT(drift.SquaredDistance({1, 0, 0.1}, 100), drift.SquaredDistance({1, 0, 0.1}, 10));
}

TEST(WaysDriven, AreTheLengthsOfThePathUpToTheNodes) {
  EXPECT_TRUE(WaysDriven({}).empty());
  const std::vector<double> ways = WaysDriven({{5, 5, 1}, {8, 9, 0}, {8, 9, 3}, {8, 7, 0}});
  EXPECT_EQ(ways, (std::vector<double>{0, 5, 5, 7}));
}

TEST(ShortestWays, WithoutClosuresAreAlongThePath) {
  const std::vector<double> driven = {0, 2, 3, 7, 12};
  EXPECT_EQ(ShortestWays(driven, {}, 2), (std::vector<double>{3, 1, 0, 4, 9}));
  EXPECT_EQ(ShortestWays({0}, {}, 0), (std::vector<double>{0}));
}

TEST(ShortestWays, AreThoseOfAnExhaustiveSearch) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> driven = {0.0};
    for (int k = 1; k < 25; ++k) driven.push_back(driven.back() + 0.01 * (random() % 300));
    std::vector<backend::Edge> closures;
    for (int k = 0; k < trial % 6; ++k) {
      const int i = static_cast<int>(random() % 24);
      closures.push_back(Closure(i, i + 1 + static_cast<int>(random() % (24 - i))));
    }
    const auto expected = AllShortestWays(driven, closures);
    for (int from = 0; from < 25; ++from) {
      const std::vector<double> ways = ShortestWays(driven, closures, from);
      ASSERT_EQ(ways.size(), driven.size());
      for (int to = 0; to < 25; ++to) EXPECT_NEAR(ways[to], expected[from][to], 1e-9);
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::loop_closure
