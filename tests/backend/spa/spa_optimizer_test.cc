// SPDX-License-Identifier: BSD-3-Clause
#include "backend/spa/spa_optimizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "backend/cost/edge_error.h"
#include "backend/cost/graph_cost.h"
#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

using backend::Options;
using backend::PoseGraph;
using backend::SE2;
using backend::Summary;
using backend::Termination;

Summary Optimize(PoseGraph* graph, const Options& options = {}) {
  return SpaOptimizer().Optimize(options, graph->edges, graph->nodes);
}

// Options for one step of eq. (5) from the given poses.
Options OneStep(const std::string& solver, const char* damping) {
  Options options;
  options.max_iterations = 1;
  options.initialization = backend::Initialization::kKeep;
  options.settings = {{"solver", solver}, {"damping", damping}};
  return options;
}

// The same step by dense Cholesky.
std::vector<SE2> DenseStep(const PoseGraph& graph, double lambda) {
  const backend::GraphIndex index = IndexGraph(graph);
  const BlockStructure structure = OrderByMinimumDegree(index);
  NormalEquations equations;
  Linearize(graph, index, structure, PosesOf(graph), {}, &equations);
  Eigen::MatrixXd hessian = Dense(structure, equations.hessian);
  hessian.diagonal() *= 1.0 + lambda;
  const Eigen::VectorXd step = hessian.llt().solve(Dense(equations.minus_gradient));
  std::vector<SE2> poses = PosesOf(graph);
  for (int k = 0; k < structure.columns(); ++k) {
    SE2& pose = poses[structure.node_of_column[k]];
    pose = {pose.x + step[3 * k], pose.y + step[3 * k + 1],
            backend::WrapAngle(pose.theta + step[3 * k + 2])};
  }
  return poses;
}

void ExpectSamePoses(const std::vector<SE2>& actual, const std::vector<SE2>& expected,
                     double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t k = 0; k < actual.size(); ++k) {
    EXPECT_NEAR(actual[k].x, expected[k].x, tolerance) << k;
    EXPECT_NEAR(actual[k].y, expected[k].y, tolerance) << k;
    EXPECT_NEAR(backend::WrapAngle(actual[k].theta - expected[k].theta), 0.0, tolerance) << k;
  }
}

TEST(SpaOptimizer, TakesTheStepOfDenseCholesky) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    for (const std::string solver : {"block", "cholmod"}) {
      if (solver == "cholmod" && !GMAPPING_SPA_CHOLMOD) continue;
      for (const auto& [text, lambda] : {std::pair("0", 0.0), std::pair("0.5", 0.5)}) {
        PoseGraph graph = backend::RandomGraph(seed);
        const std::vector<SE2> expected = DenseStep(graph, lambda);
        const Summary summary = Optimize(&graph, OneStep(solver, text));
        ASSERT_EQ(summary.iterations.size(), 1u);
        EXPECT_EQ(summary.iterations[0].damping, lambda);
        ExpectSamePoses(PosesOf(graph), expected, 1e-9);
      }
    }
  }
}

TEST(SpaOptimizer, ReportsCostsThatGraphCostConfirms) {
  PoseGraph graph = backend::RandomGraph(1);
  const double initial_cost = GraphCost(graph);
  const Summary summary = Optimize(&graph);
  EXPECT_EQ(summary.termination, Termination::kConverged);
  EXPECT_NEAR(summary.initial_cost, initial_cost, 1e-12 * initial_cost);
  EXPECT_NEAR(summary.final_cost, GraphCost(graph), 1e-12 * summary.final_cost);
  EXPECT_LT(summary.final_cost, initial_cost);
}

TEST(SpaOptimizer, EndsWhereTheGradientVanishes) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    PoseGraph graph = backend::RandomGraph(seed);
    Options options;
    options.cost_tolerance = 1e-14;
    Optimize(&graph, options);
    NormalEquations equations;
    const backend::GraphIndex index = IndexGraph(graph);
    Linearize(graph, index, OrderByMinimumDegree(index), PosesOf(graph), {}, &equations);
    EXPECT_LT(Dense(equations.minus_gradient).norm(), 1e-3 * equations.cost);
  }
}

TEST(SpaOptimizer, SolutionDoesNotDependOnTheOrderOfEdgesOrIds) {
  PoseGraph graph = backend::RandomGraph(4);
  PoseGraph shuffled = graph;
  std::mt19937 random(4);
  std::shuffle(shuffled.edges.begin(), shuffled.edges.end(), random);
  std::shuffle(shuffled.nodes.begin() + 1, shuffled.nodes.end(), random);
  for (backend::Node& node : shuffled.nodes) node.id = 1000 - 7 * node.id;
  for (backend::Edge& edge : shuffled.edges) {
    edge.i = 1000 - 7 * edge.i;
    edge.j = 1000 - 7 * edge.j;
  }
  Options options;
  options.cost_tolerance = 1e-14;
  Optimize(&graph, options);
  Optimize(&shuffled, options);
  std::sort(shuffled.nodes.begin(), shuffled.nodes.end(),
            [](const auto& a, const auto& b) { return a.id > b.id; });
  ExpectSamePoses(PosesOf(shuffled), PosesOf(graph), 1e-6);
}

TEST(SpaOptimizer, SolutionMovesWithTheGauge) {
  PoseGraph graph = backend::RandomGraph(4);
  const SE2 motion{100, -50, 2.5};
  PoseGraph moved = graph;
  for (backend::Node& node : moved.nodes) node.world_T_node = motion * node.world_T_node;
  Options options;
  options.cost_tolerance = 1e-14;
  Optimize(&graph, options);
  Optimize(&moved, options);
  std::vector<SE2> expected = PosesOf(graph);
  for (SE2& pose : expected) pose = motion * pose;
  ExpectSamePoses(PosesOf(moved), expected, 1e-6);
}

TEST(SpaOptimizer, GivesTheSameBytesEveryTime) {
  PoseGraph first = backend::RandomGraph(8), second = first;
  Optimize(&first);
  Optimize(&second);
  EXPECT_EQ(PosesOf(first), PosesOf(second));
}

TEST(SpaOptimizer, KeepsItsStateWhileTheGraphChanges) {
  // One object on a graph that grows, shrinks and is replaced reaches what fresh objects do.
  SpaOptimizer kept;
  for (const auto& [seed, nodes] : {std::pair(1u, 10), std::pair(1u, 40), std::pair(2u, 40),
                                    std::pair(2u, 15), std::pair(3u, 1), std::pair(4u, 30)}) {
    PoseGraph graph = backend::RandomGraph(seed, {.nodes = nodes});
    PoseGraph same = graph;
    const Summary summary = kept.Optimize({}, graph.edges, graph.nodes);
    EXPECT_EQ(summary.termination, Termination::kConverged);
    const double expected = Optimize(&same).final_cost;
    EXPECT_NEAR(summary.final_cost, expected, 1e-6 * expected + 1e-12);
  }
}

TEST(SpaOptimizer, CarriesDampingFromOneCallToTheNext) {
  SpaOptimizer optimizer;
  PoseGraph graph = backend::RandomGraph(1, {.pose_noise = 1.0});
  const Options options = OneStep("block", "1000");
  double last_damping = 1e4, last_cost = GraphCost(graph);
  for (int call = 0; call < 4; ++call) {
    const Summary summary = optimizer.Optimize(options, graph.edges, graph.nodes);
    ASSERT_EQ(summary.iterations.size(), 1u);
    EXPECT_LT(summary.final_cost, last_cost);
    EXPECT_NEAR(summary.iterations[0].damping, last_damping / 10, 1e-9);
    last_damping = summary.iterations[0].damping;
    last_cost = summary.final_cost;
  }
}

TEST(SpaOptimizer, DampsWhereGaussNewtonFails) {
  // From such a start, steps of Gauss-Newton raise the cost; the ones that count do not.
  int damped = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    PoseGraph graph = backend::RandomGraph(seed, {.pose_noise = 5.0});
    Options options;
    options.initialization = backend::Initialization::kKeep;
    options.settings = {{"max_nonmonotonic_steps", "0"}};
    const Summary summary = Optimize(&graph, options);
    damped += std::any_of(summary.iterations.begin(), summary.iterations.end(),
                          [](const auto& record) { return record.damping > 0.0; });
    EXPECT_LT(summary.final_cost, 0.01 * summary.initial_cost);
  }
  EXPECT_GT(damped, 0);
}

TEST(SpaOptimizer, LeavesABadStartByItself) {
  // Far from the minimum in angle: only the chordal relaxation leads back.
  PoseGraph graph = backend::RandomGraph(7, {.nodes = 60, .loop_closures = 60});
  PoseGraph truth = backend::RandomGraph(7, {.nodes = 60, .loop_closures = 60, .pose_noise = 0.0});
  for (std::size_t k = 1; k < graph.nodes.size(); ++k) graph.nodes[k].world_T_node = {};
  const double best = Optimize(&truth).final_cost;
  EXPECT_NEAR(Optimize(&graph).final_cost, best, 1e-6 * best);
}

TEST(SpaOptimizer, RejectsUnknownSettings) {
  PoseGraph graph = backend::RandomGraph(1);
  for (const auto& [name, value] :
       {std::pair("solver", "fast"), std::pair("slover", "block"), std::pair("damping", "-1"),
        std::pair("max_nonmonotonic_steps", "1.5")}) {
    Options options;
    options.settings[name] = value;
    EXPECT_THROW(Optimize(&graph, options), std::runtime_error) << name;
  }
}

TEST(SpaOptimizer, GoesOnAfterCovariancesAsWithoutThem) {
  PoseGraph graph = backend::RandomGraph(4), same = graph;
  SpaOptimizer optimizer, other;
  const std::vector<backend::EdgeNodes> pairs = {{5, 5}};
  for (const int node : {7, 12}) {
    optimizer.Optimize({}, graph.edges, graph.nodes);
    other.Optimize({}, same.edges, same.nodes);
    PoseGraph part = graph;
    part.edges.resize(part.edges.size() - 5);
    optimizer.Covariances(part.edges, part.nodes, pairs);
    for (PoseGraph* changed : {&graph, &same}) changed->edges[node].i_T_j.x += 0.3;
  }
  optimizer.Optimize({}, graph.edges, graph.nodes);
  other.Optimize({}, same.edges, same.nodes);
  for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
    EXPECT_NEAR(graph.nodes[k].world_T_node.x, same.nodes[k].world_T_node.x, 1e-6);
  }
}

TEST(SpaOptimizer, ReportsCostsThatAreNotFinite) {
  PoseGraph graph = backend::RandomGraph(1);
  graph.edges[3].i_T_j.x = 1e200;
  const std::vector<SE2> before = PosesOf(graph);
  EXPECT_EQ(Optimize(&graph).termination, Termination::kFailure);
  EXPECT_EQ(PosesOf(graph), before);
}

}  // namespace
}  // namespace gmapping_spa::spa
