// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/closure_mixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "backend/cost/graph_cost.h"

namespace gmapping_spa::backend {
namespace {

// Nodes on a square of 40 m, and loop closures between them: those of `right` have normal errors of
// `sigma`, the others measure any pose. Their information says 0.1 m and 0.1 rad.
struct Sample {
  PoseGraph graph;
  int right;
};

Sample MakeSample(unsigned seed, int right, int wrong, double sigma) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any(-20.0, 20.0);
  Sample sample{.graph = {}, .right = right};
  for (int k = 0; k < 100; ++k) {
    sample.graph.nodes.push_back(
        {.id = k, .world_T_node = {any(random), any(random), any(random)}});
  }
  for (int k = 0; k < right + wrong; ++k) {
    const int i = k % 100, j = (7 * k + 13) % 100;
    const SE2 truth =
        Between(sample.graph.nodes[i].world_T_node, sample.graph.nodes[j].world_T_node);
    const Eigen::Vector3d noise{sigma * normal(random), sigma * normal(random),
                                sigma * normal(random)};
    sample.graph.edges.push_back(
        {.i = i,
         .j = j,
         .i_T_j = k < right ? Plus(truth, noise) : SE2{any(random), any(random), any(random)},
         .information = InformationFromSigmas(0.1, 0.1),
         .kind = EdgeKind::kLoopClosure});
  }
  return sample;
}

ClosureMixture Fit(const PoseGraph& graph) {
  return FitClosureMixture(graph, IndexGraph(graph), PosesOf(graph));
}

TEST(FitClosureMixture, FindsTheInlierRatioAndTheInliers) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Sample sample = MakeSample(seed, 300, 200, 0.1);
    const ClosureMixture mixture = Fit(sample.graph);
    EXPECT_NEAR(mixture.inlier_ratio, 0.6, 0.01);
    EXPECT_LT(mixture.variance_factor, 1.1);
    for (std::size_t k = 0; k < sample.graph.edges.size(); ++k) {
      EXPECT_EQ(mixture.inlier_probability[k] > 0.5, static_cast<int>(k) < sample.right) << k;
    }
  }
}

TEST(FitClosureMixture, FindsHowMuchLargerTheVarianceIsThanTheEdgesSay) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    EXPECT_NEAR(Fit(MakeSample(seed, 300, 200, 0.2).graph).variance_factor, 4.0, 0.4);
  }
}

TEST(FitClosureMixture, FindsTheInliersOfEdgesThatSayByFarTooSmallACovariance) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    Sample sample = MakeSample(seed, 300, 200, 0.1);
    for (Edge& edge : sample.graph.edges) edge.information *= 1000.0;
    const ClosureMixture mixture = Fit(sample.graph);
    EXPECT_NEAR(mixture.inlier_ratio, 0.6, 0.01);
    EXPECT_NEAR(mixture.variance_factor, 1000.0, 100.0);
  }
}

TEST(FitClosureMixture, TakesAFewWrongClosuresForNoLargeVariance) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    for (const int wrong : {1, 2, 5}) {
      const ClosureMixture mixture = Fit(MakeSample(seed, 0, wrong, 0.1).graph);
      for (const double probability : mixture.inlier_probability) {
        EXPECT_LT(probability, 0.5) << seed;
      }
    }
  }
}

TEST(FitClosureMixture, JudgesClosuresThatMeasureThePositionAlone) {
  Sample sample = MakeSample(1, 300, 200, 0.1);
  for (Edge& edge : sample.graph.edges) edge.information(2, 2) = 0.0;
  const ClosureMixture mixture = Fit(sample.graph);
  EXPECT_NEAR(mixture.inlier_ratio, 0.6, 0.02);
  EXPECT_LT(mixture.variance_factor, 1.2);
  int mistaken = 0;
  for (std::size_t k = 0; k < sample.graph.edges.size(); ++k) {
    mistaken += (mixture.inlier_probability[k] > 0.5) != (static_cast<int>(k) < sample.right);
  }
  EXPECT_LT(mistaken, 5);  // some wrong ones are near the truth by chance
}

TEST(FitClosureMixture, AnOriginFarAwayIsNoPartOfTheMap) {
  Sample sample = MakeSample(1, 300, 100, 0.1);
  for (int k = 1; k < 100; ++k) {
    const SE2 motion =
        Between(sample.graph.nodes[k - 1].world_T_node, sample.graph.nodes[k].world_T_node);
    sample.graph.edges.push_back({k - 1, k, motion, InformationFromSigmas(0.1, 0.1)});
  }
  const double cost = Fit(sample.graph).outlier_cost[0];
  const SE2 origin{5e5, 4e6, 0.0};
  sample.graph.nodes.push_back({.id = 100, .world_T_node = origin, .fixed = true});
  sample.graph.edges.push_back({100, 0, Between(origin, sample.graph.nodes[0].world_T_node),
                                InformationFromSigmas(0.1, 0.1), EdgeKind::kLoopClosure});
  EXPECT_NEAR(Fit(sample.graph).outlier_cost[0], cost, 0.1);
}

TEST(FitClosureMixture, NeverTakesTheVarianceForSmaller) {
  EXPECT_EQ(Fit(MakeSample(1, 300, 0, 0.05).graph).variance_factor, 1.0);
}

TEST(FitClosureMixture, OutlierCostIsWhereBothAreAsLikely) {
  Sample sample = MakeSample(1, 300, 100, 0.1);
  const ClosureMixture mixture = Fit(sample.graph);
  // One more with exactly that error does not change the mixture by much.
  const double error = 0.1 * std::sqrt(2.0 * mixture.outlier_cost[0] * mixture.variance_factor);
  Edge edge = sample.graph.edges[0];
  edge.i_T_j =
      Between(sample.graph.nodes[edge.i].world_T_node, sample.graph.nodes[edge.j].world_T_node);
  edge.i_T_j.x += error;
  sample.graph.edges.push_back(edge);
  EXPECT_NEAR(Fit(sample.graph).inlier_probability.back(), 0.5, 0.2);
}

TEST(FitClosureMixture, ExplainsTheTruthBetterThanOtherPoses) {
  const Sample sample = MakeSample(1, 100, 50, 0.1);
  PoseGraph moved = sample.graph;
  moved.nodes[3].world_T_node.x += 1.0;
  EXPECT_LT(Fit(sample.graph).negative_log_likelihood, Fit(moved).negative_log_likelihood);
}

TEST(FitClosureMixture, OfAGraphWithoutClosuresIsItsCost) {
  PoseGraph graph = MakeSample(1, 10, 0, 0.1).graph;
  for (Edge& edge : graph.edges) edge.kind = EdgeKind::kOdometry;
  const ClosureMixture mixture = Fit(graph);
  EXPECT_DOUBLE_EQ(mixture.negative_log_likelihood, GraphCost(graph));
  EXPECT_EQ(mixture.inlier_probability, std::vector<double>(10, 1.0));
}

TEST(MixtureCost, CountsNoClosureForMoreThanItsOutlierCost) {
  const PoseGraph graph = MakeSample(1, 50, 1, 0.1).graph;
  const ClosureMixture mixture = Fit(graph);
  const std::vector<SE2> poses = PosesOf(graph);
  const std::vector<double> squared = SquaredErrors(graph, IndexGraph(graph), poses);
  double expected = mixture.outlier_cost.back();
  for (std::size_t k = 0; k < 50; ++k) expected += 0.5 * squared[k] / mixture.variance_factor;
  EXPECT_NEAR(MixtureCost(graph, IndexGraph(graph), poses, mixture), expected, 1e-9);
}

}  // namespace
}  // namespace gmapping_spa::backend
