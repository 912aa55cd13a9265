// SPDX-License-Identifier: BSD-3-Clause
// Positions instead of ids: what every algorithm on a pose graph starts with.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_GRAPH_INDEX_H_
#define GMAPPING_SPA_BACKEND_GRAPH_GRAPH_INDEX_H_

#include <vector>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// The nodes that an edge connects, as positions in PoseGraph::nodes.
struct EdgeNodes {
  int i = 0;
  int j = 0;
  friend bool operator==(const EdgeNodes&, const EdgeNodes&) = default;
};

struct GraphIndex {
  std::vector<EdgeNodes> edges;  // one for each of PoseGraph::edges
  // For each node, whether an optimizer leaves it where it is: fixed nodes, and the first node of
  // each connected component that has none.
  std::vector<bool> fixed;
};

// Throws std::invalid_argument with one line when two nodes share an id or an edge names a node
// that does not exist.
GraphIndex IndexGraph(const PoseGraphView& graph);

// For each node, the first one of its connected component.
std::vector<int> ComponentsOf(const GraphIndex& index);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_GRAPH_INDEX_H_
