// SPDX-License-Identifier: BSD-3-Clause
// What a program and the process of a back end tell each other, a packet each.
#ifndef GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_PACKETS_H_
#define GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_PACKETS_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backend/graph/pose_graph.h"
#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// Of Optimizer::CheckOptions, where there are neither nodes nor edges, or Optimizer::Optimize.
struct OptimizerRequest {
  enum class Kind : std::uint8_t { kCheckOptions, kOptimize };
  Kind kind = Kind::kCheckOptions;
  Options options;
  std::vector<Edge> edges;
  std::vector<Node> nodes;
};

std::vector<char> PackRequest(OptimizerRequest::Kind kind, const Options& options,
                              std::span<const Edge> edges, std::span<const Node> nodes);
OptimizerRequest UnpackRequest(std::span<const char> packet);

// What came of it: an exception's message, or the summary and the nodes.
struct OptimizerReply {
  bool threw = false;
  Summary summary;  // or the exception's message in it
};

std::vector<char> PackReply(const OptimizerReply& reply, std::span<const Node> nodes);
// Throws MalformedPacket when the packet is no reply for as many nodes, which then may be
// overwritten in part.
OptimizerReply UnpackReply(std::span<const char> packet, std::span<Node> nodes);

// A reply for so many nodes that is larger than this makes no sense.
std::size_t LargestReply(std::size_t node_count);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_PLUGIN_OPTIMIZER_PACKETS_H_
