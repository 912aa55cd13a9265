// SPDX-License-Identifier: BSD-3-Clause
// Between the C of plugin_abi.h and the types of this library. Nodes and edges lie in memory alike
// on both sides, so that a graph crosses without being copied.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_ABI_CONVERSION_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_ABI_CONVERSION_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "backend/graph/pose_graph.h"
#include "backend/plugin/optimizer.h"
#include "backend/plugin/plugin_abi.h"

namespace gmapping_spa::backend {

static_assert(std::is_standard_layout_v<Node> && sizeof(Node) == sizeof(GmappingSpaNode));
static_assert(offsetof(Node, id) == offsetof(GmappingSpaNode, id));
static_assert(offsetof(Node, stamp_s) == offsetof(GmappingSpaNode, stamp_s));
static_assert(offsetof(Node, world_T_node) == offsetof(GmappingSpaNode, x_m));
static_assert(offsetof(Node, fixed) == offsetof(GmappingSpaNode, fixed) && sizeof(bool) == 1);
static_assert(std::is_standard_layout_v<Edge> && sizeof(Edge) == sizeof(GmappingSpaEdge));
static_assert(offsetof(Edge, i) == offsetof(GmappingSpaEdge, i));
static_assert(offsetof(Edge, j) == offsetof(GmappingSpaEdge, j));
static_assert(offsetof(Edge, i_T_j) == offsetof(GmappingSpaEdge, x_m));
static_assert(offsetof(Edge, information) == offsetof(GmappingSpaEdge, information));
static_assert(offsetof(Edge, kind) == offsetof(GmappingSpaEdge, kind));
static_assert(sizeof(EdgeKind) == 1 &&
              static_cast<int>(EdgeKind::kLoopClosure) == GMAPPING_SPA_EDGE_LOOP_CLOSURE);
static_assert(std::is_standard_layout_v<SE2> && offsetof(SE2, x) == 0 &&
              offsetof(SE2, y) == sizeof(double) && offsetof(SE2, theta) == 2 * sizeof(double));
static_assert(static_cast<int>(LossKind::kTruncated) == GMAPPING_SPA_LOSS_TRUNCATED);
static_assert(static_cast<int>(Termination::kFailure) == GMAPPING_SPA_FAILURE);

static_assert(sizeof(EdgeNodes) == sizeof(GmappingSpaNodePair) && sizeof(int) == 4);
static_assert(offsetof(EdgeNodes, i) == offsetof(GmappingSpaNodePair, i));
static_assert(offsetof(EdgeNodes, j) == offsetof(GmappingSpaNodePair, j));

inline GmappingSpaGraph ToAbi(std::span<const Edge> edges, std::span<Node> nodes) {
  return {reinterpret_cast<GmappingSpaNode*>(nodes.data()), nodes.size(),
          reinterpret_cast<const GmappingSpaEdge*>(edges.data()), edges.size()};
}

inline std::span<Node> NodesOf(const GmappingSpaGraph& graph) {
  return {reinterpret_cast<Node*>(graph.nodes), graph.node_count};
}

inline std::span<const Edge> EdgesOf(const GmappingSpaGraph& graph) {
  return {reinterpret_cast<const Edge*>(graph.edges), graph.edge_count};
}

// The bit of a loss in GmappingSpaPlugin::losses.
inline std::uint32_t LossBit(LossKind kind) { return 1U << static_cast<unsigned>(kind); }

inline GmappingSpaLoss ToAbi(const Loss& loss) {
  return {static_cast<std::int32_t>(loss.kind), loss.scale, loss.control};
}

// Without the settings, whose memory is the caller's.
inline GmappingSpaOptions ToAbi(const Options& options) {
  return {options.max_iterations,
          static_cast<std::uint8_t>(KeepsStart(options)),
          options.cost_tolerance,
          options.max_solver_time_s,
          ToAbi(options.loss),
          nullptr,
          0};
}

inline Options FromAbi(const GmappingSpaOptions& plain) {
  Options options;
  options.max_iterations = plain.max_iterations;
  options.initialization = plain.keep_start != 0 ? Initialization::kKeep : Initialization::kAuto;
  options.cost_tolerance = plain.cost_tolerance;
  options.max_solver_time_s = plain.max_solver_time_s;
  options.loss = {static_cast<LossKind>(plain.loss.kind), plain.loss.scale, plain.loss.control};
  for (std::size_t k = 0; k < plain.setting_count; ++k) {
    options.settings[plain.settings[k].name] = plain.settings[k].value;
  }
  return options;
}

inline GmappingSpaIteration ToAbi(const IterationRecord& record) {
  return {record.cost, record.step_norm, record.damping, record.linear_solver_s, record.total_s};
}

inline IterationRecord FromAbi(const GmappingSpaIteration& iteration) {
  return {iteration.cost, iteration.step_norm, iteration.damping, iteration.linear_solver_s,
          iteration.total_s};
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_ABI_CONVERSION_H_
