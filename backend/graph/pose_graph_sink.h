// SPDX-License-Identifier: BSD-3-Clause
// Where a front end emits its pose graph, node by node and edge by edge.
#ifndef GMAPPING_SPA_BACKEND_GRAPH_POSE_GRAPH_SINK_H_
#define GMAPPING_SPA_BACKEND_GRAPH_POSE_GRAPH_SINK_H_

#include "backend/graph/pose_graph.h"

namespace gmapping_spa::backend {

class PoseGraphSink {
 public:
  virtual ~PoseGraphSink() = default;
  virtual void AddNode(const Node& node) = 0;
  // Both nodes were added before.
  virtual void AddEdge(const Edge& edge) = 0;
};

// Keeps what it gets.
class PoseGraphRecorder : public PoseGraphSink {
 public:
  void AddNode(const Node& node) override { graph_.nodes.push_back(node); }
  void AddEdge(const Edge& edge) override { graph_.edges.push_back(edge); }
  const PoseGraph& graph() const { return graph_; }

 private:
  PoseGraph graph_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_GRAPH_POSE_GRAPH_SINK_H_
