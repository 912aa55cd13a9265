// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/multifrontal_cholesky.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

struct Analysis {
  BlockStructure structure;
  Fronts fronts;

  explicit Analysis(const backend::PoseGraph& graph)
      : structure(OrderByNestedDissection(backend::IndexGraph(graph))) {
    EliminationTree tree;
    ExtendTree(structure, &tree);
    fronts = FindFronts(structure, tree);
  }
};

template <int kSize>
void ExpectFrontsSolveLikeDenseCholesky(unsigned seed) {
  const Analysis analysis(backend::RandomGraph(seed, {.nodes = 80, .loop_closures = 60}));
  const BlockMatrix<kSize> matrix = RandomMatrix<kSize>(analysis.structure, seed);
  typename BlockMatrix<kSize>::Vector x = RandomVector<kSize>(analysis.structure, seed);
  const Eigen::VectorXd expected = Dense(analysis.structure, matrix).llt().solve(Dense(x));
  MultifrontalCholesky cholesky;
  ASSERT_TRUE(cholesky.Solve(analysis.structure, analysis.fronts, matrix, 1, &x));
  EXPECT_LT((Dense(x) - expected).norm(), 1e-9 * expected.norm());
}

TEST(MultifrontalCholesky, SolvesLikeDenseCholesky) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    ExpectFrontsSolveLikeDenseCholesky<2>(seed);
    ExpectFrontsSolveLikeDenseCholesky<3>(seed);
    ExpectFrontsSolveLikeDenseCholesky<4>(seed);
  }
}

TEST(MultifrontalCholesky, GivesTheSameBytesWithAnyNumberOfThreads) {
  const Analysis analysis(backend::RandomGraph(7, {.nodes = 1500, .loop_closures = 1000}));
  const PoseMatrix matrix = RandomMatrix<3>(analysis.structure, 7);
  const PoseMatrix::Vector right = RandomVector<3>(analysis.structure, 7);
  PoseMatrix::Vector alone = right;
  MultifrontalCholesky cholesky;
  ASSERT_TRUE(cholesky.Solve(analysis.structure, analysis.fronts, matrix, 1, &alone));
  for (const int threads : {2, 3, 8}) {
    PoseMatrix::Vector x = right;
    ASSERT_TRUE(cholesky.Solve(analysis.structure, analysis.fronts, matrix, threads, &x));
    EXPECT_EQ(Dense(x), Dense(alone)) << threads;
  }
}

TEST(MultifrontalCholesky, RefusesMatricesThatAreNotPositiveDefinite) {
  const Analysis analysis(backend::RandomGraph(1));
  MultifrontalCholesky cholesky;
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    PoseMatrix matrix = RandomMatrix<3>(analysis.structure, 1);
    matrix.diagonal(7)(1, 1) = bad;
    PoseMatrix::Vector x = RandomVector<3>(analysis.structure, 1);
    EXPECT_FALSE(cholesky.Solve(analysis.structure, analysis.fronts, matrix, 2, &x)) << bad;
  }
}

}  // namespace
}  // namespace gmapping_spa::spa
