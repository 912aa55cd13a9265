// SPDX-License-Identifier: BSD-3-Clause
// The online case: a graph that arrives node by node, optimized after every loop closure.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <ctime>
#include <fstream>

#include "backend/cost/graph_cost.h"
#include "backend/graph/g2o_io.h"
#include "backend/plugin/plugin_loader.h"
#include "tests/real_data.h"

namespace gmapping_spa::backend {
namespace {

struct OnlineResult {
  PoseGraph graph;
  int closures = 0;
  int failures = 0;
  double cpu_s = 0.0;  // in the optimizer
};

// Feeds the nodes of `whole` in order, each placed by its odometry, with the edges that lead back
// from it. After each node with a loop closure, the optimizer may take one iteration.
OnlineResult FeedNodeByNode(const PoseGraph& whole, Optimizer* optimizer) {
  OnlineResult result;
  Options options;
  options.max_iterations = 1;
  std::vector<std::vector<Edge>> edges_of_node(whole.nodes.size());
  for (const Edge& edge : whole.edges) edges_of_node[std::max(edge.i, edge.j)].push_back(edge);
  for (Node node : whole.nodes) {
    bool closure = false;
    for (const Edge& edge : edges_of_node[node.id]) {
      closure = closure || edge.kind == EdgeKind::kLoopClosure;
      if (edge.kind == EdgeKind::kLoopClosure) continue;
      const SE2 motion = edge.j == node.id ? edge.i_T_j : Inverse(edge.i_T_j);
      node.world_T_node = result.graph.nodes[std::min(edge.i, edge.j)].world_T_node * motion;
    }
    result.graph.nodes.push_back(node);
    for (const Edge& edge : edges_of_node[node.id]) result.graph.edges.push_back(edge);
    if (!closure) continue;
    const std::clock_t start = std::clock();
    const Summary summary = optimizer->Optimize(options, result.graph.edges, result.graph.nodes);
    result.cpu_s += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    ++result.closures;
    if (summary.termination == Termination::kFailure) ++result.failures;
  }
  return result;
}

TEST(Online, SpaKeepsManhattanOptimalWithOneIterationAClosure) {
  const auto path = RealDataPath("g2o/manhattan.g2o.gz");
  if (!path) GTEST_SKIP() << "real data not found";
  std::ifstream file(*path, std::ios::binary);
  boost::iostreams::filtering_istream in;
  in.push(boost::iostreams::gzip_decompressor());
  in.push(file);
  const PoseGraph whole = ReadG2o(in, *path);
  const OnlineResult result = FeedNodeByNode(whole, LoadOptimizer("spa").get());
  EXPECT_EQ(result.closures, 1374);
  EXPECT_EQ(result.failures, 0);
  EXPECT_LE(GraphCost(result.graph), 1766.729 * (1 + 1e-5));
  RecordProperty("optimizer_cpu_ms", static_cast<int>(1e3 * result.cpu_s));
}

}  // namespace
}  // namespace gmapping_spa::backend
