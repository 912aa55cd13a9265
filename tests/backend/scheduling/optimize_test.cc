// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/optimize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "backend/plugin/plugin_loader.h"
#include "tests/backend/outlier_graph.h"

namespace gmapping_spa::backend::optimize_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kWrong = 12;
constexpr RandomGraphOptions kGoodGraph = {
    .nodes = 60, .loop_closures = 20, .measurement_noise = 0.03, .pose_noise = 0.5};

Options With(LossKind kind) {
  Options options;
  options.loss = {kind, 4.0};
  return options;
}

TEST(Optimize, SaysHowManyClosuresAreRejected) {
  for (const LossKind kind : {LossKind::kMixture, LossKind::kDcs, LossKind::kTruncated}) {
    PoseGraph graph = OutlierGraph(1, kWrong, kGoodGraph);
    const Summary summary = Optimize(With(kind), true, LoadOptimizer("spa").get(), &graph);
    std::vector<std::size_t> wrong;
    for (std::size_t k = graph.edges.size() - kWrong; k < graph.edges.size(); ++k) {
      wrong.push_back(k);
    }
    EXPECT_EQ(RejectedClosures(graph.edges, summary), wrong) << LossKindName(kind);
    EXPECT_THAT(summary.message, HasSubstr("12 of ")) << LossKindName(kind);
    EXPECT_THAT(summary.message, Not(HasSubstr("most"))) << LossKindName(kind);
  }
}

TEST(Optimize, SaysSoWhenMostClosuresAreRejected) {
  PoseGraph graph = OutlierGraph(1, 30, kGoodGraph);
  const Summary summary =
      Optimize(With(LossKind::kMixture), true, LoadOptimizer("spa").get(), &graph);
  EXPECT_THAT(summary.message, HasSubstr("that is most of them"));
}

TEST(Optimize, SaysNothingOfAGraphWithoutWrongClosures) {
  PoseGraph graph = RandomGraph(1, kGoodGraph);
  const Summary summary =
      Optimize(With(LossKind::kMixture), true, LoadOptimizer("spa").get(), &graph);
  EXPECT_THAT(summary.message, Not(HasSubstr("rejected")));
}

class PlainOptimizer : public Optimizer {
 public:
  void CheckOptions(const Options& options) const override {
    if (options.loss.kind != LossKind::kNone) throw std::runtime_error("no losses");
  }
  Summary Optimize(const Options&, std::span<const Edge>, std::span<Node>) override { return {}; }
};

TEST(CheckOptions, OfAMixtureNeedsDcs) {
  EXPECT_THROW(CheckOptions(With(LossKind::kMixture), PlainOptimizer()), std::runtime_error);
  EXPECT_NO_THROW(CheckOptions({}, PlainOptimizer()));
  EXPECT_NO_THROW(CheckOptions(With(LossKind::kMixture), *LoadOptimizer("spa")));
}

}  // namespace
}  // namespace gmapping_spa::backend::optimize_test
