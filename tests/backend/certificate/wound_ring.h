// SPDX-License-Identifier: BSD-3-Clause
// A local minimum that is known.
#ifndef GMAPPING_SPA_TESTS_BACKEND_CERTIFICATE_WOUND_RING_H_
#define GMAPPING_SPA_TESTS_BACKEND_CERTIFICATE_WOUND_RING_H_

#include <numbers>

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

// Nodes on a regular polygon with sides of 1 m, measured without error, each from the one before.
// The given poses turn `turns` times on the way around, where once is right; sides fit all the
// same. Every edge then has the same error of its angle, and the cost is a local minimum.
inline PoseGraph WoundRing(int nodes, int turns) {
  const double turn = 2.0 * std::numbers::pi / nodes;
  PoseGraph graph;
  SE2 pose;
  for (int k = 0; k < nodes; ++k) {
    graph.nodes.push_back({.id = k, .world_T_node = pose});
    pose = pose * SE2{1.0, 0.0, turns * turn};
    graph.edges.push_back({k,
                           (k + 1) % nodes,
                           {1.0, 0.0, turn},
                           InformationFromSigmas(0.1, 0.05),
                           EdgeKind::kLoopClosure});
  }
  return graph;
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_TESTS_BACKEND_CERTIFICATE_WOUND_RING_H_
