// SPDX-License-Identifier: BSD-3-Clause
#include "backend/scheduling/covariances.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "backend/plugin/plugin_loader.h"
#include "backend/scheduling/optimize.h"
#include "tests/backend/outlier_graph.h"
#include "tests/message_of.h"

namespace gmapping_spa::backend::covariances_test {
namespace {

using ::testing::HasSubstr;

// Tells what the test likes.
class Teller : public Optimizer {
 public:
  Summary Optimize(const Options&, std::span<const Edge>, std::span<Node>) override { return {}; }
  bool HasCovariances() const override { return has_covariances; }
  std::vector<Eigen::Matrix3d> Covariances(std::span<const Edge>, std::span<const Node>,
                                           std::span<const EdgeNodes>) override {
    return told;
  }
  bool has_covariances = true;
  std::vector<Eigen::Matrix3d> told;
};

const std::vector<EdgeNodes> kPairs = {{4, 4}, {4, 0}};

TEST(Covariances, AreTheOptimizersOwnOrComeFromTheFactor) {
  const PoseGraph graph = RandomGraph(1);
  Teller teller;
  teller.told = {Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero()};
  EXPECT_EQ(Covariances(graph, kPairs, &teller), teller.told);
  teller.has_covariances = false;
  const std::vector<Eigen::Matrix3d> expected =
      Covariances(graph, kPairs, LoadOptimizer("spa").get());
  const std::vector<Eigen::Matrix3d> found = Covariances(graph, kPairs, &teller);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], expected[0]);
  EXPECT_GT(found[0](0, 0), 0.0);
  EXPECT_EQ(found[1], Eigen::Matrix3d::Zero());
}

TEST(Covariances, RefusesWhatCanBeNone) {
  const PoseGraph graph = RandomGraph(1);
  const Eigen::Matrix3d good = Eigen::Matrix3d::Identity(), zero = Eigen::Matrix3d::Zero();
  const auto error_of = [&](std::vector<Eigen::Matrix3d> told) {
    Teller teller;
    teller.told = std::move(told);
    return MessageOf([&] { Covariances(graph, kPairs, &teller); });
  };
  EXPECT_EQ(error_of({good, zero}), "no error");
  EXPECT_THAT(error_of({good}), HasSubstr("of another number of pairs"));
  EXPECT_THAT(error_of({good, good}), HasSubstr("of a held node that is not zero"));
  EXPECT_THAT(error_of({-good, zero}), HasSubstr("with a negative variance"));
  EXPECT_THAT(error_of({good * std::numeric_limits<double>::quiet_NaN(), zero}),
              HasSubstr("that is not finite"));
}

TEST(EdgesOfResult, AreThoseWhoseLeastSquaresTheResultIs) {
  constexpr int kWrong = 8;
  for (const LossKind kind :
       {LossKind::kMixture, LossKind::kTruncated, LossKind::kCauchy, LossKind::kHuber}) {
    PoseGraph graph = OutlierGraph(2, kWrong, {.nodes = 40, .loop_closures = 30});
    Options options;
    options.loss = {kind, 4.0};
    options.cost_tolerance = 1e-12;
    const std::unique_ptr<Optimizer> spa = LoadOptimizer("spa");
    const Summary summary = Optimize(options, true, spa.get(), &graph);
    PoseGraph used{graph.nodes, EdgesOfResult(options.loss, graph.edges, summary)};
    const bool leaves_out = kind == LossKind::kMixture || kind == LossKind::kTruncated;
    EXPECT_EQ(used.edges.size(), graph.edges.size() - (leaves_out ? kWrong : 0));
    Options plain;
    plain.initialization = Initialization::kKeep;
    plain.cost_tolerance = 1e-12;
    spa->Optimize(plain, used.edges, used.nodes);
    for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
      const Eigen::Vector3d moved = Minus(used.nodes[k].world_T_node, graph.nodes[k].world_T_node);
      EXPECT_LT(moved.norm(), 1e-4) << LossKindName(kind) << ' ' << k;
    }
  }
}

// Of poses drawn from the covariances.
TEST(RelativeCovariance, IsThatOfRelativePosesDrawn) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const SE2 world_T_i{1.0, 2.0, 0.7}, world_T_j{4.0, -1.0, 2.5};
  Eigen::Matrix<double, 6, 6> root;
  for (double& entry : root.reshaped()) entry = 1e-3 * normal(random);
  const Eigen::Matrix<double, 6, 6> joint = root * root.transpose();
  const Eigen::Matrix3d covariance =
      RelativeCovariance(world_T_i, world_T_j, joint.topLeftCorner<3, 3>(),
                         joint.topRightCorner<3, 3>(), joint.bottomRightCorner<3, 3>());
  const SE2 i_T_j = Between(world_T_i, world_T_j);
  Eigen::Matrix3d drawn = Eigen::Matrix3d::Zero();
  constexpr int kCount = 40000;
  for (int k = 0; k < kCount; ++k) {
    Eigen::Matrix<double, 6, 1> unit;
    for (double& entry : unit) entry = normal(random);
    const Eigen::Matrix<double, 6, 1> error = root * unit;
    const Eigen::Vector3d off =
        Minus(Between(Plus(world_T_i, error.head<3>()), Plus(world_T_j, error.tail<3>())), i_T_j);
    drawn += off * off.transpose() / kCount;
  }
  EXPECT_LT((drawn - covariance).norm(), 0.02 * covariance.norm());
}

}  // namespace
}  // namespace gmapping_spa::backend::covariances_test
