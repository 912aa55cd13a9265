// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/marginal_covariance.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "backend/sparse/graph_structure.h"
#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

class MarginalCovarianceOf : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    const auto seed = static_cast<unsigned>(GetParam());
    structure_.Update(backend::IndexGraph(backend::RandomGraph(
        seed, {.nodes = 2 + 7 * GetParam(), .loop_closures = 5 * GetParam()})));
    const PoseMatrix matrix = RandomMatrix<3>(structure_.blocks(), seed);
    dense_ = Dense(structure_.blocks(), matrix).inverse();
    PoseMatrix::Vector zero(columns(), PoseMatrix::Segment::Zero());
    ASSERT_TRUE(cholesky_.Solve(structure_.blocks(), structure_.symbolic(), matrix, &zero));
  }
  int columns() const { return structure_.blocks().columns(); }
  Eigen::Matrix3d Expected(int a, int b) const { return dense_.block<3, 3>(3 * a, 3 * b); }
  double Tolerance() const { return 1e-10 * dense_.cwiseAbs().maxCoeff(); }

  GraphStructure structure_;
  BlockCholesky cholesky_;
  Eigen::MatrixXd dense_;
};

INSTANTIATE_TEST_SUITE_P(, MarginalCovarianceOf, ::testing::Range(0, 12));

TEST_P(MarginalCovarianceOf, HasTheBlocksOfTheDenseInverseOnThePatternOfTheFactor) {
  MarginalCovariance covariance(structure_.tree(), structure_.symbolic(), cholesky_);
  covariance.Recur();
  const SymbolicFactor& symbolic = structure_.symbolic();
  for (int k = 0; k < columns(); ++k) {
    ASSERT_TRUE(covariance.IsKnown(k, k));
    EXPECT_EQ(covariance.Of(k, k), covariance.Of(k, k).transpose());
    EXPECT_LT((covariance.Of(k, k) - Expected(k, k)).norm(), Tolerance());
    for (int p = symbolic.row_begin[k]; p < symbolic.row_begin[k + 1]; ++p) {
      const int i = symbolic.row_pattern[p];
      ASSERT_TRUE(covariance.IsKnown(i, k) && covariance.IsKnown(k, i));
      EXPECT_LT((covariance.Of(i, k) - Expected(i, k)).norm(), Tolerance());
      EXPECT_EQ(covariance.Of(k, i), covariance.Of(i, k).transpose());
    }
  }
}

TEST_P(MarginalCovarianceOf, HasAnyBlockByColumns) {
  MarginalCovariance covariance(structure_.tree(), structure_.symbolic(), cholesky_);
  for (int a = 0; a < columns(); ++a) {
    covariance.SetColumn(a);
    for (int b = 0; b < columns(); ++b) {
      EXPECT_FALSE(covariance.IsKnown(a, b));
      EXPECT_LT((covariance.Of(a, b) - Expected(a, b)).norm(), Tolerance());
    }
  }
}

TEST_P(MarginalCovarianceOf, HasByColumnsWhatTheRecursionLacks) {
  MarginalCovariance covariance(structure_.tree(), structure_.symbolic(), cholesky_);
  covariance.Recur();
  for (int a = 0; a < columns(); ++a) {
    for (int b = columns() - 1; b >= 0; --b) {
      if (!covariance.IsKnown(a, b)) covariance.SetColumn(a);
      EXPECT_LT((covariance.Of(a, b) - Expected(a, b)).norm(), Tolerance());
    }
  }
}

}  // namespace
}  // namespace gmapping_spa::spa
