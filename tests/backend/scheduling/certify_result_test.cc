// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/certify_result.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/cost/graph_cost.h"
#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize.h"
#include "tests/backend/certificate/wound_ring.h"
#include "tests/backend/outlier_graph.h"

namespace gmapping_spa::backend::certify_result_test {
namespace {

using testing::HasSubstr;

constexpr RandomGraphOptions kGoodGraph = {
    .nodes = 60, .loop_closures = 60, .measurement_noise = 0.03, .pose_noise = 0.5};

// A graph with what was made of it.
struct Certified {
  Certified(PoseGraph the_graph, LossKind kind, bool descend = true,
            Initialization initialization = Initialization::kAuto)
      : graph(std::move(the_graph)), optimizer(LoadOptimizer("spa")) {
    Options options;
    options.loss = {kind, 3.0};
    options.initialization = initialization;
    summary = Optimize(options, true, optimizer.get(), &graph);
    optimized = PosesOf(graph);
    result = CertifyResult(options.loss, descend, optimizer.get(), &graph, &summary);
  }

  PoseGraph graph;
  std::unique_ptr<Optimizer> optimizer;
  Summary summary;
  std::vector<SE2> optimized;
  CertifiedResult result;
};

TEST(CertifyResult, IsAboutAllEdgesWithoutALoss) {
  const Certified certified(RandomGraph(1, kGoodGraph), LossKind::kNone);
  EXPECT_TRUE(certified.result.proved());
  EXPECT_THAT(certified.result.problem, HasSubstr("least squares of all"));
  EXPECT_THAT(certified.result.message, HasSubstr("the poses are the global optimum"));
  EXPECT_EQ(certified.result.staircase.certificate.cost, GraphCost(certified.graph));
}

TEST(CertifyResult, ReplacesALocalMinimumAndSaysSo) {
  const Certified certified(WoundRing(20, 2), LossKind::kNone, true, Initialization::kKeep);
  EXPECT_TRUE(certified.result.proved());
  EXPECT_NE(PosesOf(certified.graph), certified.optimized);
  EXPECT_EQ(certified.summary.final_cost, GraphCost(certified.graph));
  EXPECT_LT(certified.summary.final_cost, 1e-9);
  EXPECT_THAT(certified.result.message, HasSubstr("times as much and are replaced"));
  EXPECT_THAT(certified.result.message, HasSubstr("the poses are the global optimum"));
}

TEST(CertifyResult, IsUndecidedAtALocalMinimumThatIsToBeKept) {
  const Certified certified(WoundRing(20, 2), LossKind::kNone, false, Initialization::kKeep);
  EXPECT_FALSE(certified.result.proved());
  EXPECT_EQ(PosesOf(certified.graph), certified.optimized);
  EXPECT_THAT(certified.result.message, HasSubstr("undecided"));
}

TEST(CertifyResult, IsAboutTheEdgesThatAMixtureAccepts) {
  constexpr int kWrong = 20;
  const Certified certified(OutlierGraph(1, kWrong, kGoodGraph), LossKind::kMixture);
  EXPECT_TRUE(certified.result.proved());
  const std::size_t edges = certified.graph.edges.size();
  EXPECT_THAT(certified.result.problem,
              HasSubstr("the " + std::to_string(edges - kWrong) + " of " + std::to_string(edges) +
                        " edges that are not rejected"));
  // All edges together have another optimum.
  PoseGraph all = certified.graph;
  EXPECT_FALSE(Certifier(all).Certify(PosesOf(all)).optimal());
}

TEST(CertifyResult, MovesNothingUnderALossThatIsNotLeastSquares) {
  for (const LossKind kind : {LossKind::kHuber, LossKind::kCauchy, LossKind::kTruncated}) {
    const Certified certified(OutlierGraph(2, 10, kGoodGraph), kind);
    EXPECT_EQ(PosesOf(certified.graph), certified.optimized);
    EXPECT_THAT(certified.result.problem, HasSubstr(std::string("the loss ") + LossKindName(kind) +
                                                    " at the poses, not the loss itself"));
    EXPECT_TRUE(certified.result.staircase.descents.empty());
  }
}

TEST(CertifyResult, NeverRaisesTheCostOfTheLoss) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    PoseGraph graph = OutlierGraph(seed, 30, {.nodes = 40, .loop_closures = 20});
    Options options;
    options.loss.kind = LossKind::kMixture;
    options.initialization = Initialization::kKeep;
    const std::unique_ptr<Optimizer> optimizer = LoadOptimizer("spa");
    Summary summary = Optimize(options, true, optimizer.get(), &graph);
    const double before = summary.final_cost;
    CertifyResult(options.loss, true, optimizer.get(), &graph, &summary);
    EXPECT_LE(summary.final_cost, before * (1.0 + 1e-12)) << seed;
  }
}

}  // namespace
}  // namespace gmapping_spa::backend::certify_result_test
