// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/adjacency.h"

#include <gtest/gtest.h>

namespace gmapping_spa::spa {
namespace {

TEST(MakeAdjacency, HasEachConnectedPairOnceAboveTheDiagonal) {
  backend::GraphIndex index;
  index.edges = {{0, 1}, {2, 0}, {1, 0}, {3, 3}, {2, 1}, {4, 2}};
  const Adjacency adjacency = MakeAdjacency(index, {0, 1, 2, 3, -1}, 0, 0, 4);
  EXPECT_EQ(adjacency.begin, (std::vector<int>{0, 0, 1, 3, 3}));
  EXPECT_EQ(adjacency.row, (std::vector<int>{0, 0, 1}));
}

TEST(MakeAdjacency, OfNewColumnsHasTheirPairsWithOldOnes) {
  backend::GraphIndex index;
  index.edges = {{0, 1}, {1, 2}, {0, 3}, {3, 2}};
  const Adjacency adjacency = MakeAdjacency(index, {0, 1, 2, 3}, 1, 2, 4);
  EXPECT_EQ(adjacency.begin, (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(adjacency.row, (std::vector<int>{1, 0, 2}));
}

}  // namespace
}  // namespace gmapping_spa::spa
