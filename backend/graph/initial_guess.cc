// SPDX-License-Identifier: BSD-3-Clause
#include "backend/graph/initial_guess.h"

#include <queue>

namespace gmapping_spa::backend {
namespace {

// The edges at each node, in compressed rows.
struct Incidence {
  std::vector<int> begin;  // size nodes + 1
  std::vector<int> edge;
};

Incidence MakeIncidence(const GraphIndex& index, int node_count) {
  Incidence incidence{std::vector<int>(node_count + 1, 0), std::vector<int>()};
  for (const EdgeNodes& nodes : index.edges) {
    ++incidence.begin[nodes.i + 1];
    ++incidence.begin[nodes.j + 1];
  }
  for (int k = 0; k < node_count; ++k) incidence.begin[k + 1] += incidence.begin[k];
  incidence.edge.resize(incidence.begin.back());
  std::vector<int> next(incidence.begin.begin(), incidence.begin.end() - 1);
  for (int e = 0; e < static_cast<int>(index.edges.size()); ++e) {
    incidence.edge[next[index.edges[e].i]++] = e;
    incidence.edge[next[index.edges[e].j]++] = e;
  }
  return incidence;
}

void InitializeAlongTree(const PoseGraphView& graph, const GraphIndex& index, bool prefer_odometry,
                         std::vector<SE2>* poses) {
  const int node_count = static_cast<int>(graph.nodes.size());
  const Incidence incidence = MakeIncidence(index, node_count);
  std::vector<bool> reached = index.fixed;
  std::queue<int> along_odometry, along_any;
  for (int k = 0; k < node_count; ++k) {
    if (!reached[k]) continue;
    along_odometry.push(k);
    along_any.push(k);
  }
  while (!along_odometry.empty() || !along_any.empty()) {
    const bool odometry_only = prefer_odometry && !along_odometry.empty();
    std::queue<int>& queue = odometry_only || along_any.empty() ? along_odometry : along_any;
    const int from = queue.front();
    queue.pop();
    for (int k = incidence.begin[from]; k < incidence.begin[from + 1]; ++k) {
      const Edge& edge = graph.edges[incidence.edge[k]];
      const EdgeNodes& nodes = index.edges[incidence.edge[k]];
      if (odometry_only && edge.kind == EdgeKind::kLoopClosure) continue;
      const int to = nodes.i == from ? nodes.j : nodes.i;
      if (reached[to]) continue;
      (*poses)[to] = (*poses)[from] * (nodes.i == from ? edge.i_T_j : Inverse(edge.i_T_j));
      reached[to] = true;
      along_odometry.push(to);
      along_any.push(to);
    }
  }
}

}  // namespace

void InitializeFromOdometry(const PoseGraphView& graph, const GraphIndex& index,
                            std::vector<SE2>* poses) {
  InitializeAlongTree(graph, index, /*prefer_odometry=*/true, poses);
}

void InitializeFromSpanningTree(const PoseGraphView& graph, const GraphIndex& index,
                                std::vector<SE2>* poses) {
  InitializeAlongTree(graph, index, /*prefer_odometry=*/false, poses);
}

}  // namespace gmapping_spa::backend
