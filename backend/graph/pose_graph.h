// SPDX-License-Identifier: BSD-3-Clause
// The pose graph: what a front end emits and a back end optimizes. Plain data.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_POSE_GRAPH_H_
#define GMAPPING_SPA_BACKEND_GRAPH_POSE_GRAPH_H_

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "backend/se2.h"

namespace gmapping_spa::backend {

// A robot pose to be estimated.
struct Node {
  std::int64_t id = 0;
  double stamp_s = 0.0;
  SE2 world_T_node;    // current estimate
  bool fixed = false;  // known: no optimizer moves it
};

enum class EdgeKind : std::uint8_t { kOdometry, kScanMatch, kLoopClosure };

// A measured relative pose. `information` is the inverse covariance of (x, y, theta) of i_T_j, its
// translation expressed in frame i: the convention of .g2o files.
struct Edge {
  std::int64_t i = 0;  // id of the node that the measurement is expressed in
  std::int64_t j = 0;
  SE2 i_T_j;
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  EdgeKind kind = EdgeKind::kOdometry;
};

// Information of a measurement whose x, y and theta are off independently of each other, by these
// standard deviations.
inline Eigen::Matrix3d InformationFromSigmas(double sigma_m, double sigma_rad) {
  return Eigen::Array3d(sigma_m, sigma_m, sigma_rad).square().inverse().matrix().asDiagonal();
}

// Nodes and edges in the order in which they were added. Ids need not be dense nor sorted. A
// connected component none of whose nodes is fixed is held by its first node.
struct PoseGraph {
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

// A pose graph to read, wherever its nodes and edges are kept: algorithms take this, so that a
// graph crosses the boundary of a plugin without being copied.
struct PoseGraphView {
  std::span<const Node> nodes;
  std::span<const Edge> edges;

  PoseGraphView(std::span<const Node> the_nodes, std::span<const Edge> the_edges)
      : nodes(the_nodes), edges(the_edges) {}
  PoseGraphView(const PoseGraph& graph) : nodes(graph.nodes), edges(graph.edges) {}  // NOLINT
};

inline std::vector<SE2> PosesOf(const PoseGraphView& graph) {
  std::vector<SE2> poses;
  poses.reserve(graph.nodes.size());
  for (const Node& node : graph.nodes) poses.push_back(node.world_T_node);
  return poses;
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_POSE_GRAPH_H_
