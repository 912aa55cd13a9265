// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/graph_structure.h"

#include <gtest/gtest.h>

#include "tests/backend/random_graph.h"

namespace gmapping_spa::spa {
namespace {

backend::GraphIndex Chain(int nodes) {
  backend::GraphIndex index;
  index.fixed.assign(nodes, false);
  index.fixed[0] = true;
  for (int k = 0; k + 1 < nodes; ++k) index.edges.push_back({k, k + 1});
  return index;
}

TEST(GraphStructure, ChangesOnlyWithTheGraph) {
  GraphStructure structure;
  structure.Update(Chain(10));
  EXPECT_TRUE(structure.changed());
  structure.Update(Chain(10));
  EXPECT_FALSE(structure.changed());
  structure.Update(Chain(9));
  EXPECT_TRUE(structure.changed());
  EXPECT_EQ(structure.blocks().columns(), 8);
  backend::GraphIndex other = Chain(9);
  other.edges.back() = {2, 8};
  structure.Update(other);
  EXPECT_TRUE(structure.changed());
  other.fixed[5] = true;
  structure.Update(other);
  EXPECT_TRUE(structure.changed());
  EXPECT_EQ(structure.blocks().columns(), 7);
}

TEST(GraphStructure, KeepsTheOrderOfAGraphThatGrows) {
  GraphStructure structure;
  structure.Update(Chain(20));
  const std::vector<int> order = structure.blocks().node_of_column;
  structure.Update(Chain(22));
  EXPECT_TRUE(std::equal(order.begin(), order.end(), structure.blocks().node_of_column.begin()));
  EXPECT_EQ(structure.symbolic().columns(), 21);
}

TEST(GraphStructure, OrdersAnewBeforeTheFactorFillsUp) {
  // Every new node sees two far ones: in the order of arrival that fills the factor.
  GraphStructure grown, fresh;
  backend::GraphIndex index = Chain(40);
  for (int k = 40; k < 400; ++k) {
    index.fixed.push_back(false);
    index.edges.push_back({k - 1, k});
    index.edges.push_back({(k * 37) % (k - 1), k});
    grown.Update(index);
  }
  fresh.Update(index);
  EXPECT_LT(grown.tree().block_products,
            2 * fresh.tree().block_products + 100 * index.fixed.size());
}

std::vector<char> Saved(const GraphStructure& structure) {
  backend::PacketWriter packet;
  structure.Save(&packet);
  return packet.bytes();
}

TEST(GraphStructure, IsLoadedAsItWasSaved) {
  GraphStructure saved, loaded;
  saved.Update(Chain(20));
  const std::vector<char> bytes = Saved(saved);
  backend::PacketReader packet(bytes);
  loaded.Load(&packet);
  EXPECT_EQ(loaded.blocks().node_of_column, saved.blocks().node_of_column);
  loaded.Update(Chain(20));
  EXPECT_FALSE(loaded.changed());
}

TEST(GraphStructure, OrderingOfColumnsThatAreNotThereIsRefused) {
  std::vector<char> bytes = Saved(GraphStructure());
  bytes[3 * sizeof(std::int64_t)] = 1;  // columns, behind edges, nodes and products
  backend::PacketReader packet(bytes);
  GraphStructure loaded;
  EXPECT_THROW(loaded.Load(&packet), backend::MalformedPacket);
}

}  // namespace
}  // namespace gmapping_spa::spa
