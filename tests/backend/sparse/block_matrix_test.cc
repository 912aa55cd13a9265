// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/block_matrix.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

TEST(BlockMatrix, OfAnotherSizeStartsAtZeroInTheSameMemory) {
  const BlockStructure structure = OrderByMinimumDegree(IndexGraph(backend::RandomGraph(1)));
  BlockMatrix<2> small = RandomMatrix<2>(structure, 1);
  const double* const memory = small.off_diagonal_data();
  BlockMatrix<4> large(std::move(small));
  large.SetZero(structure);
  EXPECT_EQ(large.off_diagonal_data(), memory);
  EXPECT_TRUE(Dense(structure, large).isZero(0.0));
  // The former one gets memory of its own.
  small.SetZero(structure);  // NOLINT(bugprone-use-after-move)
  EXPECT_NE(small.off_diagonal_data(), memory);
}

TEST(BlockMatrix, TransposesTheBlockOfAnEdgeEliminatedBackwards) {
  const BlockStructure structure = OrderByMinimumDegree(IndexGraph(backend::RandomGraph(1)));
  PoseMatrix::Block block;
  block << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  PoseMatrix matrix;
  matrix.SetZero(structure);
  matrix.AddOffDiagonal({.block = 2, .transposed = false}, block);
  EXPECT_EQ(matrix.off_diagonal(2), block);
  matrix.AddOffDiagonal({.block = 2, .transposed = true}, block);
  EXPECT_EQ(matrix.off_diagonal(2), block + block.transpose());
  matrix.AddOffDiagonal({}, block);  // of a held node: nowhere
  EXPECT_EQ(matrix.off_diagonal(2), block + block.transpose());
}

}  // namespace
}  // namespace gmapping_spa::spa
