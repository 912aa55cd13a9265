// SPDX-License-Identifier: BSD-3-Clause
// What back ends keep between calls, for runs that are gone on with.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "backend/plugin/plugin_loader.h"
#include "tests/backend/random_graph.h"
#include "tests/built_back_ends.h"
#include "tests/message_of.h"

namespace gmapping_spa::backend {
namespace {

class StateOfBackend : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(, StateOfBackend, ::testing::ValuesIn(Built({"none", "spa", "ceres"})),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(StateOfBackend, GoesOnInAnotherObjectToTheSameBits) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const std::unique_ptr<Optimizer> first = LoadOptimizer(GetParam()),
                                     second = LoadOptimizer(GetParam());
    PoseGraph graph = RandomGraph(seed);
    // Node by node, so that the ordering is one that has grown.
    for (std::int64_t id = 100; id < 110; ++id) {
      const std::int64_t last = graph.nodes.back().id;
      graph.nodes.push_back({id, 0.0, graph.nodes.back().world_T_node * SE2{1, 0, 0.1}});
      graph.edges.push_back({last, id, {1, 0, 0.11}, Eigen::Matrix3d::Zero()});
      first->Optimize({}, graph.edges, graph.nodes);
    }
    const std::optional<std::string> state = first->State();
    ASSERT_TRUE(state);
    second->SetState(*state);
    EXPECT_EQ(second->State(), state);
    graph.nodes.push_back({200, 0.0, graph.nodes.back().world_T_node * SE2{1, 0, 0.1}});
    graph.edges.push_back({109, 200, {1, 0, 0.11}, Eigen::Matrix3d::Zero()});
    PoseGraph other = graph;
    first->Optimize({}, graph.edges, graph.nodes);
    second->Optimize({}, other.edges, other.nodes);
    EXPECT_EQ(PosesOf(other), PosesOf(graph)) << seed;
    EXPECT_EQ(second->State(), first->State());
  }
}

TEST_P(StateOfBackend, RefusesWhatIsNoState) {
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(GetParam());
  PoseGraph graph = RandomGraph(1);
  optimizer->Optimize({}, graph.edges, graph.nodes);
  const std::string state = optimizer->State().value();
  for (const std::string& nonsense : {state + "x", std::string("none"), state + state}) {
    if (nonsense == state) continue;  // where nothing is kept, nothing twice is the same
    EXPECT_EQ(MessageOf([&] { LoadOptimizer(GetParam())->SetState(nonsense); }),
              "this is no state of the back end");
  }
}

}  // namespace
}  // namespace gmapping_spa::backend
