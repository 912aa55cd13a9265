// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/certifier.h"

#include <gtest/gtest.h>

#include "backend/cost/graph_cost.h"
#include "backend/spa/spa_optimizer.h"
#include "tests/backend/certificate/wound_ring.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend::certifier_test {
namespace {

// Where the optimizer comes to from other poses.
std::vector<SE2> Minimum(PoseGraph graph, const std::vector<SE2>& start) {
  for (std::size_t k = 0; k < start.size(); ++k) graph.nodes[k].world_T_node = start[k];
  Options options;
  options.initialization = Initialization::kKeep;
  options.cost_tolerance = 1e-12;
  spa::SpaOptimizer().Optimize(options, graph.edges, graph.nodes);
  return PosesOf(graph);
}

TEST(Certifier, AgreesWithManyStartsOnRandomGraphs) {
  int optima = 0, certified = 0, rejected = 0;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    // Information of all kinds, errors of half a radian: local minima abound.
    PoseGraph graph = RandomGraph(seed, {.nodes = 7, .loop_closures = 5, .measurement_noise = 0.4});
    for (Edge& edge : graph.edges) edge.information /= 100.0;
    if (seed % 2 == 0) {
      for (Edge& edge : graph.edges) edge.information = InformationFromSigmas(0.3, 0.3);
    }
    if (seed % 3 == 0) graph.nodes[4].fixed = true;
    const GraphIndex index = IndexGraph(graph);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<std::vector<SE2>> minima;
    double least = std::numeric_limits<double>::infinity();
    for (int start = 0; start < 60; ++start) {
      std::vector<SE2> poses = PosesOf(graph);
      for (std::size_t k = 0; k < poses.size(); ++k) {
        if (index.fixed[k]) continue;
        poses[k] =
            Plus(poses[k], 2.0 * Eigen::Vector3d(normal(random), normal(random), normal(random)));
      }
      minima.push_back(Minimum(graph, poses));
      least = std::min(least, GraphCost(graph, index, minima.back()));
    }
    Certifier certifier(graph);
    bool optimum_certified = false;
    for (const std::vector<SE2>& poses : minima) {
      const Certificate certificate = certifier.Certify(poses);
      EXPECT_LE(certificate.lower_bound, least * (1.0 + 1e-9)) << seed;
      EXPECT_NEAR(certificate.lower_bound, (1.0 - certificate.relative_gap) * certificate.cost,
                  1e-9 * certificate.cost);
      if (certificate.optimal()) {
        EXPECT_LE(certificate.cost, least * (1.0 + 2e-6)) << seed;
        optimum_certified = true;
      } else if (certificate.cost > least * 1.01) {
        // Nearly all have a direction to leave along; an angle may be off by pi, though.
        Certificate completed = certificate;
        if (certifier.NegativeCurvature(&completed)) ++rejected;
      }
    }
    ++optima;
    certified += optimum_certified ? 1 : 0;
  }
  EXPECT_GE(certified, optima * 2 / 3);
  EXPECT_GE(rejected, 100);
}

TEST(Certifier, BoundsTheCostOfAnyPosesThatAreNotAMinimum) {
  const PoseGraph graph = RandomGraph(2, {.pose_noise = 1e-3});
  const GraphIndex index = IndexGraph(graph);
  const std::vector<SE2> optimum = Minimum(graph, PosesOf(graph));
  const double least = GraphCost(graph, index, optimum);
  Certifier certifier(graph);
  const Certificate best = certifier.Certify(optimum);
  EXPECT_TRUE(best.optimal());
  EXPECT_TRUE(best.positive_definite);
  EXPECT_LT(best.relative_gap, 1e-9);
  EXPECT_EQ(best.cost, least);
  for (const double change : {1e-2, 1e-4, 1e-6}) {
    std::vector<SE2> poses = optimum;
    for (std::size_t k = 1; k < poses.size(); ++k) {
      const double phase = static_cast<double>(k);
      poses[k] = Plus(poses[k], change * Eigen::Vector3d(std::sin(phase), std::cos(phase),
                                                         std::sin(2.0 * phase)));
    }
    const Certificate certificate = certifier.Certify(poses);
    EXPECT_LE(certificate.lower_bound, least * (1.0 + 1e-12));
    EXPECT_EQ(certificate.optimal(), certificate.relative_gap <= kOptimalGap);
  }
}

TEST(Certifier, RejectsARingThatIsWoundUp) {
  for (const int nodes : {8, 20, 50}) {
    const PoseGraph graph = WoundRing(nodes, 2);
    const std::vector<SE2> minimum = Minimum(graph, PosesOf(graph));
    Certifier certifier(graph);
    Certificate certificate = certifier.Certify(minimum);
    EXPECT_GT(certificate.cost, 1.0);
    EXPECT_FALSE(certificate.optimal());
    EXPECT_TRUE(certifier.NegativeCurvature(&certificate).has_value());
    EXPECT_LT(certificate.smallest_eigenvalue, 0.0);
    EXPECT_LE(certificate.lower_bound, 1e-9);
  }
}

TEST(Certifier, CertifiesPosesWithoutErrors) {
  const PoseGraph graph = WoundRing(12, 1);
  const Certificate certificate = Certifier(graph).Certify(PosesOf(graph));
  EXPECT_TRUE(certificate.optimal());
  EXPECT_LT(certificate.cost, 1e-20);
}

TEST(Certifier, TakesHeldPosesAsTheyAre) {
  PoseGraph graph = RandomGraph(5);
  graph.nodes[10].fixed = graph.nodes[20].fixed = true;
  const Certificate some = Certifier(graph).Certify(Minimum(graph, PosesOf(graph)));
  EXPECT_TRUE(some.optimal());
  for (Node& node : graph.nodes) node.fixed = true;
  const Certificate all = Certifier(graph).Certify(PosesOf(graph));
  EXPECT_TRUE(all.optimal());
  EXPECT_EQ(all.lower_bound, all.cost);
}

TEST(Certifier, ProvesNothingWherePosesAreNotDetermined) {
  PoseGraph graph = RandomGraph(5);
  for (Edge& edge : graph.edges) edge.information(0, 0) = edge.information(0, 1) = 0.0;
  for (Edge& edge : graph.edges) edge.information(1, 0) = 0.0;
  for (Edge& edge : graph.edges) edge.information(0, 2) = edge.information(2, 0) = 0.0;
  Certifier certifier(graph);
  Certificate certificate = certifier.Certify(PosesOf(graph));
  EXPECT_FALSE(certificate.optimal());
  EXPECT_FALSE(certifier.NegativeCurvature(&certificate).has_value());
  EXPECT_EQ(certificate.lower_bound, 0.0);
}

}  // namespace
}  // namespace gmapping_spa::backend::certifier_test
