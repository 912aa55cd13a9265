// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/run_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gmapping_spa::view {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// "tiles" for binary ones.
std::vector<std::string> Ops(const Messages& messages) {
  std::vector<std::string> ops;
  for (const MessagePtr& message : messages) {
    ops.push_back(message->is_binary ? "tiles" : json::parse(message->data)["op"]);
  }
  return ops;
}

json Find(const Messages& messages, const std::string& op) {
  for (const MessagePtr& message : messages) {
    if (message->is_binary) continue;
    if (json parsed = json::parse(message->data); parsed["op"] == op) return parsed;
  }
  return {};
}

GraphSnapshot ThreeNodes() {
  GraphSnapshot graph;
  graph.nodes = {{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}, {2.0, {2, 0.12345, 0}}};
  graph.candidates.resize(2);
  graph.candidates[0].node = 2;
  graph.candidates[1].node = 2;
  graph.candidates[1].old_node = 1;
  return graph;
}

Snapshot WithGraph(GraphSnapshot graph) {
  Snapshot snapshot;
  snapshot.graph = std::make_shared<const GraphSnapshot>(std::move(graph));
  return snapshot;
}

TEST(RunState, NothingIsKnownBeforeTheFirstSnapshot) {
  EXPECT_THAT(RunState(0, {}).All(), IsEmpty());
}

TEST(RunState, OnlyWhatChangedIsTold) {
  RunState state(0, {});
  Snapshot first = WithGraph(ThreeNodes());
  first.grid = map::OccupancyGrid({});
  first.grid->AddHit(0.5, 0.5);
  const Snapshot second = first;
  EXPECT_THAT(Ops(state.Apply(std::move(first))),
              ElementsAre("tiles", "nodes", "candidates", "health", "frame"));
  EXPECT_THAT(Ops(state.Apply(second)), ElementsAre("frame"));
  EXPECT_THAT(Ops(state.All()), ElementsAre("tiles", "nodes", "candidates", "health", "frame"));
}

TEST(RunState, NodesAreToldFromTheFirstThatMoved) {
  RunState state(0, {});
  state.Apply(WithGraph(ThreeNodes()));
  GraphSnapshot moved = ThreeNodes();
  moved.nodes[1].world_T_robot.y = 0.5;
  moved.nodes.push_back({3.0, {3, 0, 0}});
  const json nodes = Find(state.Apply(WithGraph(moved)), "nodes");
  EXPECT_EQ(nodes["from"], 1);
  EXPECT_EQ(nodes["poses"], json::parse("[1.0,0.5,0.0,1.0,2.0,0.123,0.0,2.0,3.0,0.0,0.0,3.0]"));
  moved.nodes.resize(1);
  const json fewer = Find(state.Apply(WithGraph(moved)), "nodes");
  EXPECT_EQ(fewer["from"], 1);
  EXPECT_THAT(fewer["poses"], IsEmpty());
}

TEST(RunState, CandidateWithAnotherVerdictIsToldAnew) {
  RunState state(3, {});
  state.Apply(WithGraph(ThreeNodes()));
  GraphSnapshot decided = ThreeNodes();
  decided.candidates[1].verdict = loop_closure::Verdict::kAccepted;
  const json candidates = Find(state.Apply(WithGraph(decided)), "candidates");
  EXPECT_EQ(candidates["run"], 3);
  EXPECT_EQ(candidates["total"], 2);
  ASSERT_EQ(candidates["changed"].size(), 1U);
  EXPECT_EQ(candidates["changed"][0]["position"], 1);
  EXPECT_EQ(candidates["changed"][0]["verdict"], "accepted");
}

TEST(RunState, RevisionsCountWhatChanged) {
  RunState state(0, {});
  state.Apply(WithGraph(ThreeNodes()));
  state.Apply(Snapshot{});
  EXPECT_EQ(state.revisions().frame, 2);
  EXPECT_EQ(state.revisions().graph, 1);
  EXPECT_EQ(state.revisions().map, 0);
  EXPECT_EQ(state.revisions().health, 1);
  EXPECT_EQ(state.graph().nodes.size(), 3U);
}

TEST(RunState, TextThatIsNoUtf8AndNumbersThatAreNoneAreToldAsJson) {
  RunState state(0, {.name = "log\xff"});
  Snapshot snapshot;
  snapshot.health.findings["odd"] = {
      .message = "\xff", .first_stamp_s = 0.0, .last_stamp_s = 0.0, .count = 1};
  const Messages messages = state.Apply(std::move(snapshot));
  EXPECT_EQ(Find(messages, "health")["findings"][0]["message"], "\xEF\xBF\xBD");
  EXPECT_TRUE(Find(messages, "frame")["figures"][7].is_null());
}

}  // namespace
}  // namespace gmapping_spa::view
