// SPDX-License-Identifier: BSD-3-Clause
// Random pose graphs with wrong loop closures.
#ifndef GMAPPING_SPA_TESTS_BACKEND_OUTLIER_GRAPH_H_
#define GMAPPING_SPA_TESTS_BACKEND_OUTLIER_GRAPH_H_

#include <random>

#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend {

// A graph whose last `count` edges are wrong loop closures between nodes that are far from each
// other; the others are right. Same seed, same graph.
inline PoseGraph OutlierGraph(unsigned seed, int count, const RandomGraphOptions& options) {
  PoseGraph graph = RandomGraph(seed, options);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(0, options.nodes - 1);
  for (int k = 0; k < count; ++k) {
    const int i = any(random), j = (i + options.nodes / 3 + k) % options.nodes;
    graph.edges.push_back(
        {i, j, {0, 0, 1}, 300 * Eigen::Matrix3d::Identity(), EdgeKind::kLoopClosure});
  }
  return graph;
}

// Largest distance in m between nodes of two graphs.
inline double LargestDistance(const PoseGraph& a, const PoseGraph& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.nodes.size(); ++k) {
    const SE2 error = Between(a.nodes[k].world_T_node, b.nodes[k].world_T_node);
    largest = std::max(largest, error.translation().norm());
  }
  return largest;
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_TESTS_BACKEND_OUTLIER_GRAPH_H_
