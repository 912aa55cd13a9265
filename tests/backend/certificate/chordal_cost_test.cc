// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/chordal_cost.h"

#include <gtest/gtest.h>

#include "backend/cost/edge_error.h"
#include "backend/cost/graph_cost.h"
#include "tests/backend/random_graph.h"

namespace gmapping_spa::backend::chordal_cost_test {
namespace {

class ChordalCostTest : public ::testing::Test {
 protected:
  ChordalCostTest() {
    structure_.Update(IndexGraph(graph_));
    for (const Edge& edge : graph_.edges) splits_.push_back(SplitInformation(edge.information));
  }

  double Cost(const LiftedPoses& poses) const {
    const LiftedPoses gradient =
        ChordalCost(graph_, structure_, splits_).Gradient(poses, /*free_only=*/false);
    return 0.5 * poses.conjugate().cwiseProduct(gradient).sum().real();
  }

  PoseGraph graph_ = RandomGraph(6);
  spa::GraphStructure structure_;
  std::vector<InformationSplit> splits_;
};

TEST_F(ChordalCostTest, IsThatOfChordsAndAtMostTheCostOfThePoses) {
  double expected = 0.0;
  for (std::size_t k = 0; k < graph_.edges.size(); ++k) {
    const auto [i, j] = structure_.index().edges[k];
    const Eigen::Vector3d error = EdgeError(graph_.nodes[i].world_T_node,
                                            graph_.nodes[j].world_T_node, graph_.edges[k].i_T_j);
    expected += 0.5 * splits_[k].translation * error.head<2>().squaredNorm() +
                splits_[k].rotation * (1.0 - std::cos(error.z()));
  }
  const double cost = Cost(LiftPoses(PosesOf(graph_), 1));
  EXPECT_NEAR(cost, expected, 1e-9 * expected);
  EXPECT_NEAR(Cost(LiftPoses(PosesOf(graph_), 3)), expected, 1e-9 * expected);
  EXPECT_LT(cost, GraphCost(graph_));
}

TEST_F(ChordalCostTest, HasTheMatrixOfItsGradient) {
  const ChordalCost cost(graph_, structure_, splits_);
  const std::vector<int>& nodes = structure_.blocks().node_of_column;
  LiftedPoses direction = LiftedPoses::Zero(2 * static_cast<int>(graph_.nodes.size()), 1);
  LiftedVector x(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    x[k] = Eigen::Vector4d::Random();
    direction(2 * nodes[k], 0) = Complex(x[k][0], x[k][1]);
    direction(2 * nodes[k] + 1, 0) = Complex(x[k][2], x[k][3]);
  }
  const LiftedVector product = Multiply(structure_.blocks(), cost.Matrix(), x);
  const LiftedPoses gradient = cost.Gradient(direction, /*free_only=*/true);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Complex t = gradient(2 * nodes[k], 0), z = gradient(2 * nodes[k] + 1, 0);
    EXPECT_LT((product[k] - Eigen::Vector4d(t.real(), t.imag(), z.real(), z.imag())).norm(), 1e-8);
  }
  EXPECT_EQ(gradient.topRows(2).norm(), 0.0);  // of the held node
}

}  // namespace
}  // namespace gmapping_spa::backend::chordal_cost_test
