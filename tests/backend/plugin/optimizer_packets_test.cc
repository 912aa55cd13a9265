// SPDX-License-Identifier: BSD-3-Clause
#include "backend/plugin/optimizer_packets.h"

#include <gtest/gtest.h>

#include <vector>

#include "backend/packet.h"

namespace gmapping_spa::backend {
namespace {

const std::vector<Node> kNodes = {{7, 1.5, {1.0, 2.0, 3.0}, true}, {9, 2.5, {-1.0, 0.5, -0.0}}};

TEST(OptimizerPackets, RequestsComeBackAsTheyWere) {
  Options options;
  options.max_iterations = 3;
  options.cost_tolerance = 0.25;
  options.initialization = Initialization::kKeep;
  options.loss = {LossKind::kDcs, 2.5};
  options.settings = {{"solver", "cholmod"}, {"empty", ""}};
  const std::vector<Edge> edges = {{7, 9, {0.1, 0.2, 0.3}}};
  const OptimizerRequest request =
      UnpackRequest(PackRequest(OptimizerRequest::Kind::kOptimize, options, edges, kNodes));
  EXPECT_EQ(request.kind, OptimizerRequest::Kind::kOptimize);
  EXPECT_EQ(request.options, options);
  ASSERT_EQ(request.edges.size(), 1u);
  EXPECT_EQ(request.edges[0].i_T_j, edges[0].i_T_j);
  ASSERT_EQ(request.nodes.size(), 2u);
  EXPECT_EQ(request.nodes[0].id, 7);
  EXPECT_TRUE(request.nodes[0].fixed);
}

std::vector<char> Reply() {
  OptimizerReply reply;
  reply.summary.termination = Termination::kConverged;
  reply.summary.message = "went well";
  reply.summary.initial_cost = 4.0;
  reply.summary.final_cost = 0.5;
  reply.summary.iterations = {{3.0}, {0.5}};
  return PackReply(reply, kNodes);
}

TEST(OptimizerPackets, RepliesComeBackAsTheyWere) {
  std::vector<Node> nodes(2);
  const OptimizerReply reply = UnpackReply(Reply(), nodes);
  EXPECT_FALSE(reply.threw);
  EXPECT_EQ(reply.summary.termination, Termination::kConverged);
  EXPECT_EQ(reply.summary.message, "went well");
  EXPECT_EQ(reply.summary.final_cost, 0.5);
  ASSERT_EQ(reply.summary.iterations.size(), 2u);
  EXPECT_EQ(reply.summary.iterations[0].cost, 3.0);
  EXPECT_EQ(nodes[1].world_T_node, kNodes[1].world_T_node);
}

TEST(OptimizerPackets, RepliesCutOffAnywhereAreRefused) {
  const std::vector<char> reply = Reply();
  for (std::size_t size = 0; size < reply.size(); ++size) {
    std::vector<Node> nodes(2);
    EXPECT_THROW(UnpackReply(std::span(reply).first(size), nodes), MalformedPacket) << size;
  }
}

TEST(OptimizerPackets, RepliesForAnotherNumberOfNodesAreRefused) {
  for (const std::size_t count : {0, 1, 3}) {
    std::vector<Node> nodes(count);
    EXPECT_THROW(UnpackReply(Reply(), nodes), MalformedPacket) << count;
  }
}

// Most bytes changed still make a reply: what matters is that all are taken or refused.
TEST(OptimizerPackets, RepliesWithAnyByteChangedDoNoHarm) {
  const std::vector<char> reply = Reply();
  for (std::size_t k = 0; k < reply.size(); ++k) {
    std::vector<char> changed = reply;
    changed[k] = static_cast<char>(~changed[k]);
    std::vector<Node> nodes(2);
    try {
      EXPECT_LE(UnpackReply(changed, nodes).summary.termination, Termination::kFailure);
    } catch (const MalformedPacket&) {
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::backend
