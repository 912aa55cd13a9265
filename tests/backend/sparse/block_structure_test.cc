// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/block_structure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/backend/random_graph.h"

namespace gmapping_spa::spa {
namespace {

using backend::GraphIndex;

// The pairs of free nodes that have a block.
std::set<std::pair<int, int>> BlockedPairs(const BlockStructure& structure) {
  std::set<std::pair<int, int>> pairs;
  for (int k = 0; k < structure.columns(); ++k) {
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      EXPECT_LT(structure.row[p], k);
      pairs.insert(
          std::minmax(structure.node_of_column[k], structure.node_of_column[structure.row[p]]));
    }
  }
  EXPECT_EQ(static_cast<int>(pairs.size()), structure.blocks());
  return pairs;
}

// Checks that each edge between two free nodes has its slot, and that nothing else has a block.
void ExpectFits(const BlockStructure& structure, const GraphIndex& index) {
  std::set<std::pair<int, int>> expected;
  ASSERT_EQ(structure.slot_of_edge.size(), index.edges.size());
  for (std::size_t e = 0; e < index.edges.size(); ++e) {
    const auto [i, j] = index.edges[e];
    const BlockStructure::Slot slot = structure.slot_of_edge[e];
    if (index.fixed[i] || index.fixed[j] || i == j) {
      EXPECT_EQ(slot.block, -1);
      continue;
    }
    expected.insert(std::minmax(i, j));
    const int row = structure.column_of_node[slot.transposed ? j : i];
    const int column = structure.column_of_node[slot.transposed ? i : j];
    ASSERT_GE(slot.block, structure.begin[column]);
    ASSERT_LT(slot.block, structure.begin[column + 1]);
    EXPECT_EQ(structure.row[slot.block], row);
  }
  EXPECT_EQ(BlockedPairs(structure), expected);
  for (std::size_t node = 0; node < index.fixed.size(); ++node) {
    const int column = structure.column_of_node[node];
    ASSERT_EQ(column < 0, index.fixed[node]);
    if (column >= 0) {
      EXPECT_EQ(structure.node_of_column[column], static_cast<int>(node));
    }
  }
}

// A graph with parallel edges, an edge from a node to itself and one between fixed nodes.
GraphIndex AwkwardIndex() {
  GraphIndex index;
  index.fixed = {true, false, false, true, false, false};
  index.edges = {{0, 1}, {1, 2}, {2, 1}, {1, 2}, {4, 4}, {0, 3}, {5, 1}, {2, 5}, {3, 4}};
  return index;
}

TEST(OrderByMinimumDegree, GivesEachEdgeItsBlock) {
  ExpectFits(OrderByMinimumDegree(AwkwardIndex()), AwkwardIndex());
  for (unsigned seed = 0; seed < 10; ++seed) {
    const GraphIndex index = IndexGraph(backend::RandomGraph(seed));
    ExpectFits(OrderByMinimumDegree(index), index);
  }
}

TEST(OrderByMinimumDegree, TakesGraphsWithoutFreeNodes) {
  GraphIndex index;
  EXPECT_EQ(OrderByMinimumDegree(index).columns(), 0);
  index.fixed = {true, true};
  index.edges = {{0, 1}};
  EXPECT_EQ(OrderByMinimumDegree(index).columns(), 0);
}

TEST(AppendNewNodes, PutsNewNodesLastAndKeepsTheRest) {
  const GraphIndex index = IndexGraph(backend::RandomGraph(5));
  GraphIndex first = index;
  first.fixed.resize(20);
  std::erase_if(first.edges, [](const auto& edge) { return std::max(edge.i, edge.j) >= 20; });
  GraphIndex whole = first;
  whole.fixed = index.fixed;
  for (const auto& edge : index.edges) {
    if (std::max(edge.i, edge.j) >= 20) whole.edges.push_back(edge);
  }
  BlockStructure structure = OrderByMinimumDegree(first);
  const std::vector<int> order = structure.node_of_column;
  ASSERT_TRUE(AppendNewNodes(whole, &structure));
  ExpectFits(structure, whole);
  EXPECT_TRUE(std::equal(order.begin(), order.end(), structure.node_of_column.begin()));
}

TEST(AppendNewNodes, RefusesNewBlocksInOldColumns) {
  GraphIndex index = AwkwardIndex();
  BlockStructure structure = OrderByMinimumDegree(index);
  index.edges.push_back({4, 1});
  EXPECT_FALSE(AppendNewNodes(index, &structure));
}

}  // namespace
}  // namespace gmapping_spa::spa
