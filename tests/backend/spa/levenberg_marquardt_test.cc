// SPDX-License-Identifier: BSD-3-Clause
#include "backend/spa/levenberg_marquardt.h"

#include <gtest/gtest.h>

#include "backend/cost/graph_cost.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::spa {
namespace {

using backend::PoseGraph;
using backend::SE2;
using backend::Summary;
using backend::Termination;

// Minimizes a graph's cost from its poses, which are replaced.
struct Outcome {
  bool finished;
  Summary summary;
  std::vector<SE2> poses;
};

Outcome Minimize(const PoseGraph& graph, const LevenbergMarquardt::Options& options) {
  GraphStructure structure;
  structure.Update(IndexGraph(graph));
  SolverMemory memory;
  const GraphProblem problem{graph, structure, {}};
  Outcome outcome{false, {}, PosesOf(graph)};
  problem.LinearizeAt(outcome.poses, &memory);
  LevenbergMarquardt minimizer;
  outcome.finished =
      minimizer.Minimize(options, problem, &memory, &outcome.poses, &outcome.summary);
  return outcome;
}

TEST(LevenbergMarquardt, EndsWhereNoPoseCanBeChangedForTheBetter) {
  const PoseGraph graph = backend::RandomGraph(2);
  const Outcome outcome = Minimize(graph, {.cost_tolerance = 1e-12});
  EXPECT_TRUE(outcome.finished);
  EXPECT_EQ(outcome.summary.termination, Termination::kConverged);
  const backend::GraphIndex index = IndexGraph(graph);
  const double cost = GraphCost(graph, index, outcome.poses);
  EXPECT_NEAR(outcome.summary.final_cost, cost, 1e-12 * cost);
  for (std::size_t k = 1; k < outcome.poses.size(); ++k) {
    for (const Eigen::Vector3d& change :
         {Eigen::Vector3d(1e-4, 0, 0), Eigen::Vector3d(0, 1e-4, 0), Eigen::Vector3d(0, 0, 1e-4)}) {
      for (const double sign : {-1.0, 1.0}) {
        std::vector<SE2> other = outcome.poses;
        other[k] = Plus(other[k], sign * change);
        EXPECT_GT(GraphCost(graph, index, other), cost * (1.0 - 1e-9)) << k;
      }
    }
  }
}

TEST(LevenbergMarquardt, EndsAtACostThatIsRounding) {
  // A chain along an arc: its edges agree, and the smallest cost is zero but for rounding.
  PoseGraph graph;
  graph.nodes.resize(2000);
  for (int k = 1; k < 2000; ++k) {
    graph.nodes[k].id = k;
    graph.nodes[k].world_T_node = {0.9 * k, 0.0, 0.0};
    backend::Edge edge;
    edge.i = k - 1;
    edge.j = k;
    edge.i_T_j = {1.01, 0.01, 0.001};
    edge.information = Eigen::Vector3d(400, 400, 2500).asDiagonal();
    graph.edges.push_back(edge);
  }
  const Outcome outcome = Minimize(graph, {});
  EXPECT_EQ(outcome.summary.termination, Termination::kConverged);
  EXPECT_LT(outcome.summary.final_cost, 1e-15);
  EXPECT_LT(outcome.summary.iterations.size(), 10u);
}

TEST(LevenbergMarquardt, TakesNoStepAfterTheDeadline) {
  const PoseGraph graph = backend::RandomGraph(2);
  const Outcome outcome = Minimize(graph, {.deadline = std::chrono::steady_clock::now()});
  EXPECT_TRUE(outcome.finished);
  EXPECT_EQ(outcome.summary.termination, Termination::kNoConvergence);
  EXPECT_EQ(outcome.summary.message, "ran out of time");
  EXPECT_TRUE(outcome.summary.iterations.empty());
  EXPECT_EQ(outcome.poses, PosesOf(graph));
}

TEST(LevenbergMarquardt, GivesUpEarlyWhereDampingWouldHaveToStart) {
  // Without any information there is no Gauss-Newton step.
  PoseGraph graph = backend::RandomGraph(2);
  for (backend::Edge& edge : graph.edges) edge.information.setZero();
  EXPECT_FALSE(Minimize(graph, {.give_up_early = true}).finished);
  EXPECT_TRUE(Minimize(graph, {}).finished);
}

}  // namespace
}  // namespace gmapping_spa::spa
