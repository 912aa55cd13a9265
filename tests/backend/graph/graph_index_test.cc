// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/graph_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace gmapping_spa::backend {
namespace {

using ::testing::ElementsAre;

PoseGraph MakeGraph(const std::vector<std::int64_t>& ids,
                    const std::vector<std::pair<std::int64_t, std::int64_t>>& edges) {
  PoseGraph graph;
  for (const std::int64_t id : ids) graph.nodes.push_back({id, 0.0, {}});
  for (const auto& [i, j] : edges) graph.edges.push_back({i, j, {}});
  return graph;
}

TEST(IndexGraph, FindsNodesWhateverTheirIds) {
  EXPECT_THAT(IndexGraph(MakeGraph({5, 6, 7}, {{5, 7}, {6, 5}})).edges,
              ElementsAre(EdgeNodes{0, 2}, EdgeNodes{1, 0}));
  EXPECT_THAT(IndexGraph(MakeGraph({9, -3, 1'000'000'000'000}, {{1'000'000'000'000, 9}})).edges,
              ElementsAre(EdgeNodes{2, 0}));
}

TEST(IndexGraph, HoldsTheFirstNodeOfEachComponent) {
  const PoseGraph graph = MakeGraph({0, 1, 2, 3, 4, 5}, {{4, 1}, {5, 4}, {3, 2}});
  EXPECT_THAT(IndexGraph(graph).fixed, ElementsAre(true, true, true, false, false, false));
}

TEST(IndexGraph, HoldsFixedNodesInstead) {
  PoseGraph graph = MakeGraph({0, 1, 2, 3, 4}, {{0, 1}, {1, 2}, {3, 4}});
  graph.nodes[1].fixed = graph.nodes[2].fixed = true;
  EXPECT_THAT(IndexGraph(graph).fixed, ElementsAre(false, true, true, true, false));
}

TEST(ComponentsOf, NamesTheFirstNodeOfEach) {
  const GraphIndex index = IndexGraph(MakeGraph({9, 8, 7, 6, 5, 4}, {{5, 8}, {4, 5}, {6, 7}}));
  EXPECT_THAT(ComponentsOf(index), ElementsAre(0, 1, 2, 2, 1, 1));
}

TEST(IndexGraph, RejectsUnknownAndRepeatedIds) {
  EXPECT_THROW(IndexGraph(MakeGraph({0, 1}, {{0, 2}})), std::invalid_argument);
  EXPECT_THROW(IndexGraph(MakeGraph({4, 9}, {{4, 5}})), std::invalid_argument);
  EXPECT_THROW(IndexGraph(MakeGraph({0, 1, 0}, {})), std::invalid_argument);
}

}  // namespace
}  // namespace gmapping_spa::backend
