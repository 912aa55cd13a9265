// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/block_cholesky.h"

#include <gtest/gtest.h>

#include <limits>

#include "backend/sparse/graph_structure.h"
#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

GraphStructure StructureOf(const backend::PoseGraph& graph) {
  GraphStructure structure;
  structure.Update(backend::IndexGraph(graph));
  return structure;
}

template <int kSize>
void ExpectSolvesLikeDenseCholesky(unsigned seed) {
  const GraphStructure structure = StructureOf(backend::RandomGraph(seed));
  const BlockMatrix<kSize> matrix = RandomMatrix<kSize>(structure.blocks(), seed);
  typename BlockMatrix<kSize>::Vector x = RandomVector<kSize>(structure.blocks(), seed);
  const Eigen::VectorXd expected = Dense(structure.blocks(), matrix).llt().solve(Dense(x));
  BlockCholesky cholesky;
  ASSERT_TRUE(cholesky.Solve(structure.blocks(), structure.symbolic(), matrix, &x));
  EXPECT_LT((Dense(x) - expected).norm(), 1e-10 * expected.norm());
}

TEST(BlockCholesky, SolvesLikeDenseCholesky) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    ExpectSolvesLikeDenseCholesky<2>(seed);
    ExpectSolvesLikeDenseCholesky<3>(seed);
    ExpectSolvesLikeDenseCholesky<4>(seed);
  }
}

TEST(BlockCholesky, ServesMatricesOfDifferentSizesInTurn) {
  BlockCholesky cholesky;
  for (const int nodes : {30, 5, 1, 60}) {
    const GraphStructure structure = StructureOf(backend::RandomGraph(1, {.nodes = nodes}));
    const PoseMatrix matrix = RandomMatrix<3>(structure.blocks(), 1);
    PoseMatrix::Vector x = RandomVector<3>(structure.blocks(), 1);
    const Eigen::VectorXd right = Dense(x);
    ASSERT_TRUE(cholesky.Solve(structure.blocks(), structure.symbolic(), matrix, &x));
    EXPECT_LT((Dense(structure.blocks(), matrix) * Dense(x) - right).norm(), 1e-9);
  }
}

TEST(BlockCholesky, SolvesAgainWithTheSameFactor) {
  const GraphStructure structure = StructureOf(backend::RandomGraph(2));
  const PoseMatrix matrix = RandomMatrix<3>(structure.blocks(), 2);
  BlockCholesky cholesky;
  PoseMatrix::Vector first = RandomVector<3>(structure.blocks(), 3);
  ASSERT_TRUE(cholesky.Solve(structure.blocks(), structure.symbolic(), matrix, &first));
  PoseMatrix::Vector x = RandomVector<3>(structure.blocks(), 4);
  const Eigen::VectorXd right = Dense(x);
  cholesky.SolveAgain<3>(structure.symbolic(), &x);
  EXPECT_LT((Dense(structure.blocks(), matrix) * Dense(x) - right).norm(), 1e-9);
}

TEST(BlockCholesky, RefusesMatricesThatAreNotPositiveDefinite) {
  const GraphStructure structure = StructureOf(backend::RandomGraph(1));
  BlockCholesky cholesky;
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    PoseMatrix matrix = RandomMatrix<3>(structure.blocks(), 1);
    matrix.diagonal(7)(1, 1) = bad;
    PoseMatrix::Vector x = RandomVector<3>(structure.blocks(), 1);
    EXPECT_FALSE(cholesky.Solve(structure.blocks(), structure.symbolic(), matrix, &x)) << bad;
  }
}

}  // namespace
}  // namespace gmapping_spa::spa
