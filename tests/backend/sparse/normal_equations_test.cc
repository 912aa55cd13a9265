// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/normal_equations.h"

#include <gtest/gtest.h>

#include "backend/cost/graph_cost.h"
#include "backend/sparse/block_structure.h"
#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

using backend::SE2;

struct DenseEquations {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd minus_gradient;
};

// The normal equations as the textbook has them: from the Jacobian of all errors.
DenseEquations Textbook(const backend::PoseGraph& graph, const backend::GraphIndex& index,
                        const BlockStructure& structure, const std::vector<SE2>& poses,
                        const backend::Loss& loss) {
  const int size = 3 * structure.columns();
  DenseEquations dense{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [i, j] = index.edges[e];
    const backend::Edge& edge = graph.edges[e];
    const backend::LinearizedEdge linear = LinearizeEdge(poses[i], poses[j], edge.i_T_j);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, size);
    const int a = structure.column_of_node[i], b = structure.column_of_node[j];
    if (a >= 0) jacobian.middleCols<3>(3 * a) += linear.jacobian_i;
    if (b >= 0) jacobian.middleCols<3>(3 * b) += linear.jacobian_j;
    const double s = linear.error.dot(edge.information * linear.error);
    const Eigen::Matrix3d information =
        EvaluateLoss(LossOfEdge(edge, loss), s).weight * edge.information;
    dense.hessian += jacobian.transpose() * information * jacobian;
    dense.minus_gradient -= jacobian.transpose() * information * linear.error;
  }
  return dense;
}

TEST(Linearize, IsTheTextbooksNormalEquations) {
  for (const backend::Loss& loss :
       {backend::Loss{}, backend::Loss{backend::LossKind::kCauchy, 2.0}}) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      backend::PoseGraph graph = backend::RandomGraph(seed);
      graph.nodes[4].fixed = graph.nodes[9].fixed = true;
      const backend::GraphIndex index = IndexGraph(graph);
      const BlockStructure structure = OrderByMinimumDegree(index);
      NormalEquations equations;
      Linearize(graph, index, structure, PosesOf(graph), loss, &equations);
      const DenseEquations expected = Textbook(graph, index, structure, PosesOf(graph), loss);
      EXPECT_NEAR(equations.cost, GraphCost(graph, loss), 1e-12 * equations.cost);
      EXPECT_LT((Dense(structure, equations.hessian) - expected.hessian).norm(),
                1e-12 * expected.hessian.norm());
      EXPECT_LT((Dense(equations.minus_gradient) - expected.minus_gradient).norm(),
                1e-11 * expected.minus_gradient.norm());
    }
  }
}

TEST(LinearizeForTranslations, IsExactWhereTheMeasurementsAgree) {
  backend::PoseGraph graph = backend::RandomGraph(1, {.measurement_noise = 0.0, .pose_noise = 0.0});
  const backend::GraphIndex index = IndexGraph(graph);
  const BlockStructure structure = OrderByMinimumDegree(index);
  const std::vector<SE2> truth = PosesOf(graph);
  std::vector<SE2> start = truth;
  for (const int node : structure.node_of_column) start[node].x = start[node].y = 0.0;
  NormalEquations equations;
  LinearizeForTranslations(graph, index, structure, start, &equations);
  const Eigen::VectorXd solution =
      Dense(structure, equations.hessian).llt().solve(Dense(equations.minus_gradient));
  for (int k = 0; k < structure.columns(); ++k) {
    const SE2& expected = truth[structure.node_of_column[k]];
    EXPECT_LT((solution.segment<3>(3 * k) - Eigen::Vector3d(expected.x, expected.y, 0)).norm(),
              1e-9);
  }
}

}  // namespace
}  // namespace gmapping_spa::spa
