// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/fronts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "backend/sparse/symbolic_factor.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::spa {
namespace {

TEST(FindFronts, HoldsThePatternOfTheFactorAndEachBlockOnce) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const backend::GraphIndex index =
        backend::IndexGraph(backend::RandomGraph(seed, {.nodes = 200, .loop_closures = 60}));
    const BlockStructure structure = OrderByNestedDissection(index);
    EliminationTree tree;
    ExtendTree(structure, &tree);
    SymbolicFactor symbolic;
    ExtendPattern(structure, tree, &symbolic);
    const Fronts fronts = FindFronts(structure, tree);

    std::set<std::pair<int, int>> held;  // row and column of L
    std::set<int> blocks;
    int next = 0;
    for (const Front& front : fronts.fronts) {
      EXPECT_EQ(front.first, next);
      next += front.pivots;
      const auto rows = fronts.row.begin() + front.row_begin;
      EXPECT_TRUE(std::is_sorted(rows, rows + front.rows));
      for (int p = front.first; p < next; ++p) {
        for (int below = p + 1; below < next; ++below) held.emplace(below, p);
        for (int r = 0; r < front.rows; ++r) held.emplace(rows[r], p);
      }
      for (int e = 0; e < front.entries; ++e) {
        const FrontEntry& entry = fronts.entry[front.entry_begin + e];
        const int row = structure.row[entry.block];
        EXPECT_TRUE(row >= front.first && row < next);
        EXPECT_TRUE(blocks.insert(entry.block).second);
      }
      if (front.parent >= 0) {
        const Front& parent = fronts.fronts[front.parent];
        EXPECT_TRUE(rows[0] >= parent.first && rows[0] < parent.first + parent.pivots);
      }
    }
    EXPECT_EQ(next, structure.columns());
    EXPECT_EQ(static_cast<int>(blocks.size()), structure.blocks());
    for (int k = 0; k < structure.columns(); ++k) {
      for (int p = symbolic.row_begin[k]; p < symbolic.row_begin[k + 1]; ++p) {
        EXPECT_TRUE(held.contains({k, symbolic.row_pattern[p]}));
      }
    }
    EXPECT_LT(held.size(), 2 * symbolic.row_pattern.size());  // zeros are few
  }
}

}  // namespace
}  // namespace gmapping_spa::spa
