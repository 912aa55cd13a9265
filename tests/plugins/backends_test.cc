// SPDX-License-Identifier: BSD-3-Clause
// What holds for every back end, loaded as users load them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <fstream>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "backend/cost/graph_cost.h"
#include "backend/graph/g2o_io.h"
#include "backend/graph/initial_guess.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/covariances.h"
#include "backend/scheduling/optimize_safely.h"
#include "tests/backend/random_graph.h"
#include "tests/built_back_ends.h"
#include "tests/message_of.h"
#include "tests/real_data.h"

namespace gmapping_spa::backend {
namespace {

class EveryBackend : public ::testing::TestWithParam<const char*> {
 protected:
  // By the optimizer itself, without OptimizeSafely's safety net.
  Summary Optimize(PoseGraph* graph, const Options& options = {}) {
    return LoadOptimizer(GetParam())->Optimize(options, graph->edges, graph->nodes);
  }
};
class EveryOptimizer : public EveryBackend {};

INSTANTIATE_TEST_SUITE_P(, EveryBackend, ::testing::ValuesIn(Built({"none", "spa", "ceres"})),
                         [](const auto& test) { return std::string(test.param); });
INSTANTIATE_TEST_SUITE_P(, EveryOptimizer, ::testing::ValuesIn(Built({"spa", "ceres"})),
                         [](const auto& test) { return std::string(test.param); });

Eigen::Matrix3d Information(double value) { return value * Eigen::Matrix3d::Identity(); }

TEST_P(EveryBackend, NeverReturnsWorsePosesThanItGot) {
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(GetParam());
  for (unsigned seed = 0; seed < 60; ++seed) {
    PoseGraph graph = RandomGraph(seed, {.nodes = 2 + static_cast<int>(seed % 30),
                                         .loop_closures = static_cast<int>(seed % 7) * 5,
                                         .measurement_noise = 0.05 * (seed % 4),
                                         .pose_noise = 0.5 * (seed % 5)});
    Options options;
    options.max_iterations = static_cast<int>(seed % 6);
    options.initialization = seed % 2 == 0 ? Initialization::kAuto : Initialization::kKeep;
    options.loss = {static_cast<LossKind>(seed / 5 % 5), 1.0 + seed % 3};
    const std::vector<Node> before = graph.nodes;
    const GraphIndex index = IndexGraph(graph);
    const double initial_cost = GraphCost(graph, options.loss);
    const Summary summary = optimizer->Optimize(options, graph.edges, graph.nodes);
    EXPECT_NE(summary.termination, Termination::kFailure) << seed << ": " << summary.message;
    EXPECT_LE(GraphCost(graph, options.loss), initial_cost) << seed;
    EXPECT_NEAR(summary.final_cost, GraphCost(graph, options.loss), 1e-9 * initial_cost);
    for (std::size_t k = 0; k < before.size(); ++k) {
      EXPECT_TRUE(graph.nodes[k].world_T_node.IsFinite());
      EXPECT_EQ(graph.nodes[k].id, before[k].id);
      if (index.fixed[k]) {
        EXPECT_EQ(graph.nodes[k].world_T_node, before[k].world_T_node);
      }
    }
  }
}

// Also by those that know nothing of it.
TEST_P(EveryBackend, StartsWhereItIsTold) {
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(GetParam());
  for (const Initialization initialization :
       {Initialization::kOdometry, Initialization::kSpanningTree, Initialization::kChordal}) {
    PoseGraph graph = RandomGraph(3, {.measurement_noise = 0.02, .pose_noise = 2.0});
    const auto start = InitialPoses(initialization, graph, IndexGraph(graph));
    const double start_cost = GraphCost(graph, IndexGraph(graph), start.value());
    ASSERT_LT(start_cost, GraphCost(graph) / 10.0);
    Options options;
    options.initialization = initialization;
    options.max_iterations = 0;
    const Summary summary = OptimizeSafely(options, optimizer.get(), &graph);
    EXPECT_NE(summary.termination, Termination::kFailure) << summary.message;
    EXPECT_EQ(summary.final_cost, start_cost) << InitializationName(initialization);
    EXPECT_EQ(PosesOf(graph), *start);
    // An optimizer is told where to start, not how.
    EXPECT_THROW(optimizer->Optimize(options, graph.edges, graph.nodes), std::invalid_argument);
  }
}

TEST_P(EveryBackend, TakesGraphsWithoutAnythingToDo) {
  PoseGraph graph;
  EXPECT_EQ(Optimize(&graph).termination, Termination::kConverged);
  graph.nodes.push_back({7, 0, {1, 2, 3}});
  EXPECT_EQ(Optimize(&graph).termination, Termination::kConverged);
  graph.nodes.push_back({8, 0, {4, 5, 1}});
  EXPECT_EQ(Optimize(&graph).termination, Termination::kConverged);
  graph.edges.push_back({7, 8, {1, 0, 0}, Information(1)});
  graph.nodes[0].fixed = graph.nodes[1].fixed = true;
  EXPECT_EQ(Optimize(&graph).termination, Termination::kConverged);
  EXPECT_EQ(graph.nodes[0].world_T_node, (SE2{1, 2, 3}));
  EXPECT_EQ(graph.nodes[1].world_T_node, (SE2{4, 5, 1}));
}

TEST_P(EveryOptimizer, MeetsASingleMeasurementAcrossThePi) {
  PoseGraph graph;
  graph.nodes = {{0, 0, {0, 0, 3.0}}, {1, 0, {0, 0, -3.0}}};
  graph.edges = {{0, 1, {1, 0, 0.5}, Information(10)}};
  EXPECT_EQ(Optimize(&graph).termination, Termination::kConverged);
  EXPECT_LT(GraphCost(graph), 1e-10);
  EXPECT_NEAR(graph.nodes[1].world_T_node.theta, 3.5 - 2 * std::numbers::pi, 1e-6);
}

TEST_P(EveryOptimizer, OptimizesComponentsApart) {
  PoseGraph whole = RandomGraph(1), other = RandomGraph(2);
  double expected = Optimize(&whole).final_cost + Optimize(&other).final_cost;
  whole = RandomGraph(1);
  for (Node& node : other.nodes) node.id += 1000;
  for (Edge& edge : other.edges) edge.i += 1000, edge.j += 1000;
  const SE2 first_of_other = other.nodes[0].world_T_node;
  whole.nodes.insert(whole.nodes.end(), other.nodes.begin(), other.nodes.end());
  whole.edges.insert(whole.edges.end(), other.edges.begin(), other.edges.end());
  EXPECT_NEAR(Optimize(&whole).final_cost, expected, 1e-4 * expected);
  EXPECT_EQ(whole.nodes[30].world_T_node.x, first_of_other.x);
}

TEST_P(EveryOptimizer, AddsUpDuplicateEdges) {
  PoseGraph graph;
  graph.nodes = {{0, 0, {0, 0, 0}}, {1, 0, {0, 0, 0}}};
  graph.edges = {{0, 1, {1, 0, 0}, Information(1)},
                 {1, 0, {-3, 0, 0}, Information(1)},
                 {0, 1, {1, 0, 0}, Information(2)}};
  Optimize(&graph);
  EXPECT_NEAR(graph.nodes[1].world_T_node.x, 1.5, 1e-3);
}

TEST_P(EveryBackend, IgnoresEdgesOfZeroInformation) {
  PoseGraph graph = RandomGraph(3), plain = graph;
  graph.edges.push_back({0, 5, {100, 100, 1}, Information(0)});
  graph.nodes.push_back({100, 0, {1, 1, 1}});
  graph.edges.push_back({0, 100, {1, 0, 0}, Information(0)});
  const Summary summary = Optimize(&graph), expected = Optimize(&plain);
  EXPECT_NE(summary.termination, Termination::kFailure);
  EXPECT_NEAR(summary.final_cost, expected.final_cost, 1e-4 * expected.final_cost);
  EXPECT_TRUE(graph.nodes.back().world_T_node.IsFinite());
}

TEST_P(EveryOptimizer, FollowsEdgesOfEnormousInformation) {
  PoseGraph graph = RandomGraph(3);
  graph.edges[10].information *= 1e12;
  Optimize(&graph);
  const SE2 between = Between(graph.nodes[10].world_T_node, graph.nodes[11].world_T_node);
  EXPECT_NEAR(between.x, graph.edges[10].i_T_j.x, 1e-5);
  EXPECT_NEAR(between.theta, graph.edges[10].i_T_j.theta, 1e-5);
}

TEST_P(EveryBackend, SurvivesInformationBeyondAllBounds) {
  PoseGraph graph = RandomGraph(3);
  graph.edges[10].information *= 1e305;
  const double initial_cost = GraphCost(graph);
  Optimize(&graph);
  for (const Node& node : graph.nodes) EXPECT_TRUE(node.world_T_node.IsFinite());
  EXPECT_FALSE(GraphCost(graph) > initial_cost);
}

TEST_P(EveryBackend, RefusesMalformedGraphs) {
  PoseGraph graph = RandomGraph(1);
  graph.edges[0].j = 12345;
  EXPECT_EQ(Optimize(&graph).termination, Termination::kFailure);
  graph = RandomGraph(1);
  graph.nodes[3].id = graph.nodes[4].id;
  EXPECT_EQ(Optimize(&graph).termination, Termination::kFailure);
}

TEST_P(EveryBackend, TellsTheSameCovariancesOrNone) {
  const std::unique_ptr<Optimizer> optimizer = LoadOptimizer(GetParam()),
                                   spa = LoadOptimizer("spa");
  EXPECT_EQ(optimizer->HasCovariances(), std::string(GetParam()) != "none");
  for (unsigned seed = 0; seed < 5; ++seed) {
    PoseGraph graph = RandomGraph(seed);
    graph.nodes[12].fixed = true;
    graph.nodes.push_back({99, 0.0, {1, 2, 3}});
    spa->Optimize({}, graph.edges, graph.nodes);
    const std::vector<EdgeNodes> pairs = {{3, 3},   {3, 17}, {17, 3},  {3, 17}, {12, 12},
                                          {12, 20}, {0, 29}, {30, 30}, {4, 30}};
    const std::vector<Eigen::Matrix3d> found = Covariances(graph, pairs, optimizer.get()),
                                       expected = Covariances(graph, pairs, spa.get());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      EXPECT_LE((found[k] - expected[k]).norm(), 1e-8 * expected[0].norm()) << seed << ' ' << k;
    }
    graph.edges.push_back({3, 99, {1, 0, 0}, Information(0)});
    EXPECT_THAT(MessageOf([&] { Covariances(graph, pairs, optimizer.get()); }),
                ::testing::HasSubstr("the covariances do not exist"));
  }
}

TEST_P(EveryOptimizer, DoubtsWrongLoopClosuresUnderALoss) {
  const RandomGraphOptions good = {.nodes = 40, .loop_closures = 40, .pose_noise = 0.02};
  PoseGraph reference = RandomGraph(5, good);
  Optimize(&reference);
  for (const LossKind kind : {LossKind::kCauchy, LossKind::kDcs, LossKind::kTruncated}) {
    PoseGraph graph = RandomGraph(5, good);
    graph.edges.push_back({2, 30, {0, 0, 0}, Information(1e3), EdgeKind::kLoopClosure});
    Options options;
    options.loss = {kind, 5.0};
    options.initialization = Initialization::kKeep;
    Optimize(&graph, options);
    EXPECT_NEAR(graph.nodes[30].world_T_node.x, reference.nodes[30].world_T_node.x, 0.2)
        << LossKindName(kind);
  }
}

// The best known costs: of the six published graphs those that solvers reach from chordal and from
// certified starts, of the noisier Manhattan worlds the lowest of all starts and back ends.
struct KnownGraph {
  const char* name;
  double best_cost;
  friend void PrintTo(const KnownGraph& graph, std::ostream* out) { *out << graph.name; }
};

class RealGraph : public ::testing::TestWithParam<KnownGraph> {
 protected:
  // The graph at the start that its odometry gives, or nothing.
  std::optional<PoseGraph> FromOdometry() const {
    const auto path = RealDataPath(std::string("g2o/") + GetParam().name + ".g2o.gz");
    if (!path) return std::nullopt;
    std::ifstream file(*path, std::ios::binary);
    boost::iostreams::filtering_istream in;
    in.push(boost::iostreams::gzip_decompressor());
    in.push(file);
    PoseGraph graph = ReadG2o(in, *path);
    std::vector<SE2> poses = PosesOf(graph);
    InitializeFromOdometry(graph, IndexGraph(graph), &poses);
    for (std::size_t k = 0; k < poses.size(); ++k) graph.nodes[k].world_T_node = poses[k];
    return graph;
  }
};

constexpr KnownGraph kGraphs[] = {{"intel", 22.208903989},    {"MIT", 19.800647242},
                                  {"CSAIL", 30.571486530},    {"manhattan", 1766.729262596},
                                  {"kitti_00", 49.131340934}, {"city10000", 255.992581817},
                                  {"M3500a", 456.057506086},  {"M3500b", 1027.357959028}};
// Its chordal relaxation lies in a worse basin; SPA looks further.
constexpr KnownGraph kHardGraphs[] = {{"M3500c", 1277.366195}};

std::string NameOf(const ::testing::TestParamInfo<KnownGraph>& test) { return test.param.name; }

class RealGraphByCeres : public RealGraph {};

INSTANTIATE_TEST_SUITE_P(, RealGraph, ::testing::ValuesIn(kGraphs), NameOf);
INSTANTIATE_TEST_SUITE_P(Hard, RealGraph, ::testing::ValuesIn(kHardGraphs), NameOf);
INSTANTIATE_TEST_SUITE_P(, RealGraphByCeres, ::testing::ValuesIn(kGraphs), NameOf);

TEST_P(RealGraph, SpaFindsTheBestKnownMinimumByItself) {
  std::optional<PoseGraph> graph = FromOdometry();
  if (!graph) GTEST_SKIP() << "real data not found";
  const auto optimizer = LoadOptimizer("spa");
  const Summary summary = OptimizeSafely({}, optimizer.get(), &*graph);
  EXPECT_EQ(summary.termination, Termination::kConverged);
  EXPECT_NEAR(GraphCost(*graph), GetParam().best_cost, 1e-6 * GetParam().best_cost);
}

TEST_P(RealGraph, SpaOverCholmodEndsAtTheSameCost) {
  std::optional<PoseGraph> graph = FromOdometry();
  if (!graph) GTEST_SKIP() << "real data not found";
  Options options;
  options.settings["solver"] = "cholmod";
  const auto optimizer = LoadOptimizer("spa");
  try {
    optimizer->CheckOptions(options);
  } catch (const std::runtime_error&) {
    GTEST_SKIP() << "built without CHOLMOD";
  }
  OptimizeSafely(options, optimizer.get(), &*graph);
  EXPECT_NEAR(GraphCost(*graph), GetParam().best_cost, 1e-6 * GetParam().best_cost);
}

TEST_P(RealGraphByCeres, IsSolvedFromTheChordalStart) {
  if (!kHasCeres) GTEST_SKIP() << "built without Ceres";
  std::optional<PoseGraph> graph = FromOdometry();
  if (!graph) GTEST_SKIP() << "real data not found";
  Options options;
  options.initialization = Initialization::kChordal;
  options.settings["initial_radius"] = "1e16";
  const auto optimizer = LoadOptimizer("ceres");
  OptimizeSafely(options, optimizer.get(), &*graph);
  EXPECT_NEAR(GraphCost(*graph), GetParam().best_cost, 1e-6 * GetParam().best_cost);
}

}  // namespace
}  // namespace gmapping_spa::backend
