// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/optimizer_packets.h"

#include "backend/packet.h"

namespace gmapping_spa::backend {
namespace {

// Of a message and of a million iterations.
constexpr std::size_t kLargestSummary = 64 << 20;

void PutOptions(const Options& options, PacketWriter* packet) {
  packet->Put(options.max_iterations);
  packet->Put(options.initialization);
  packet->Put(options.cost_tolerance);
  packet->Put(options.max_solver_time_s);
  packet->Put(options.loss);
  packet->Put(options.settings.size());
  for (const auto& [name, value] : options.settings) {
    packet->Put(name);
    packet->Put(value);
  }
}

Options TakeOptions(PacketReader* packet) {
  Options options;
  options.max_iterations = packet->Take<int>();
  options.initialization = packet->Take<Initialization>();
  options.cost_tolerance = packet->Take<double>();
  options.max_solver_time_s = packet->Take<double>();
  options.loss = packet->Take<Loss>();
  for (auto left = packet->Take<std::size_t>(); left > 0; --left) {
    const std::string name = packet->TakeText();
    options.settings[name] = packet->TakeText();
  }
  return options;
}

template <typename Value>
std::vector<Value> TakeCounted(PacketReader* packet) {
  const auto count = packet->Take<std::size_t>();
  packet->CheckRoom(count, sizeof(Value));
  std::vector<Value> values(count);
  packet->TakeAll(std::span<Value>(values));
  return values;
}

}  // namespace

std::vector<char> PackRequest(OptimizerRequest::Kind kind, const Options& options,
                              std::span<const Edge> edges, std::span<const Node> nodes) {
  PacketWriter packet;
  packet.Put(kind);
  PutOptions(options, &packet);
  packet.Put(edges.size());
  packet.PutAll(edges);
  packet.Put(nodes.size());
  packet.PutAll(nodes);
  return packet.bytes();
}

OptimizerRequest UnpackRequest(std::span<const char> bytes) {
  PacketReader packet(bytes);
  OptimizerRequest request;
  request.kind = packet.Take<OptimizerRequest::Kind>();
  request.options = TakeOptions(&packet);
  request.edges = TakeCounted<Edge>(&packet);
  request.nodes = TakeCounted<Node>(&packet);
  packet.CheckEnd();
  return request;
}

std::vector<char> PackReply(const OptimizerReply& reply, std::span<const Node> nodes) {
  const Summary& summary = reply.summary;
  PacketWriter packet;
  packet.Put(static_cast<std::uint8_t>(reply.threw));
  packet.Put(summary.termination);
  packet.Put(summary.message);
  packet.Put(summary.initial_cost);
  packet.Put(summary.final_cost);
  packet.Put(summary.iterations.size());
  packet.PutAll(std::span(summary.iterations));
  packet.PutAll(nodes);
  return packet.bytes();
}

OptimizerReply UnpackReply(std::span<const char> bytes, std::span<Node> nodes) {
  PacketReader packet(bytes);
  OptimizerReply reply;
  reply.threw = packet.Take<std::uint8_t>() != 0;
  Summary& summary = reply.summary;
  summary.termination = packet.Take<Termination>();
  if (summary.termination > Termination::kFailure) {
    throw MalformedPacket("a packet has no such termination");
  }
  summary.message = packet.TakeText();
  summary.initial_cost = packet.Take<double>();
  summary.final_cost = packet.Take<double>();
  summary.iterations = TakeCounted<IterationRecord>(&packet);
  packet.TakeAll(nodes);
  packet.CheckEnd();
  return reply;
}

std::size_t LargestReply(std::size_t node_count) {
  return kLargestSummary + node_count * sizeof(Node);
}

}  // namespace gmapping_spa::backend
