// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/elimination_order.h"

#include <gtest/gtest.h>

#include <numeric>

#include "backend/sparse/block_structure.h"
#include "backend/sparse/elimination_tree.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::spa {
namespace {

Adjacency AdjacencyOf(const backend::GraphIndex& index) {
  std::vector<int> all(index.fixed.size());
  std::iota(all.begin(), all.end(), 0);
  return MakeAdjacency(index, all, 0, 0, static_cast<int>(all.size()));
}

// A square of poses, each with a measurement to its neighbors.
backend::GraphIndex Square(int side) {
  backend::GraphIndex index;
  index.fixed.assign(static_cast<std::size_t>(side) * side, false);
  for (int k = 0; k < side * side; ++k) {
    if (k % side + 1 < side) index.edges.push_back({k, k + 1});
    if (k + side < side * side) index.edges.push_back({k, k + side});
  }
  return index;
}

std::int64_t Products(const BlockStructure& structure) {
  EliminationTree tree;
  ExtendTree(structure, &tree);
  return tree.block_products;
}

TEST(EliminationOrder, HasEachColumnOnce) {
  backend::GraphIndex without_edges;
  without_edges.fixed.assign(3, false);
  for (const backend::GraphIndex& index :
       {without_edges, Square(5), Square(1), backend::GraphIndex(),
        backend::IndexGraph(backend::RandomGraph(1)),
        backend::IndexGraph(backend::RandomGraph(2))}) {
    for (const auto order : {MinimumDegreeOrder, NestedDissectionOrder}) {
      std::vector<int> columns = order(AdjacencyOf(index)), all(columns.size());
      EXPECT_EQ(columns.size(), index.fixed.size());
      std::iota(all.begin(), all.end(), 0);
      std::sort(columns.begin(), columns.end());
      EXPECT_EQ(columns, all);
    }
  }
}

TEST(NestedDissectionOrder, TakesLessWorkThanMinimumDegreeWhereGraphsAreLarge) {
  const backend::GraphIndex index = Square(150);
  EXPECT_LT(Products(OrderByNestedDissection(index)), Products(OrderByMinimumDegree(index)));
}

TEST(NestedDissectionOrder, LeavesNoFillInAStretchWithoutLoops) {
  backend::GraphIndex index = Square(2);  // a loop
  for (int k = 3; k < 50; ++k) {
    index.fixed.push_back(false);
    index.edges.push_back({k, k + 1});
  }
  EliminationTree tree;
  ExtendTree(OrderByNestedDissection(index), &tree);
  EXPECT_EQ(std::accumulate(tree.count.begin(), tree.count.end(), 0),
            static_cast<int>(index.edges.size()) + 1);  // one block of fill in the loop of four
}

}  // namespace
}  // namespace gmapping_spa::spa
