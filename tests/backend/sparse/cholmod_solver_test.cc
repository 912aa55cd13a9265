// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/cholmod_solver.h"

#include <gtest/gtest.h>

#include "backend/sparse/block_cholesky.h"
#include "backend/sparse/graph_structure.h"
#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

TEST(CholmodSolver, AgreesWithBlockCholesky) {
  CholmodSolver cholmod;
  BlockCholesky cholesky;
  for (unsigned seed = 0; seed < 10; ++seed) {
    GraphStructure structure;
    structure.Update(
        backend::IndexGraph(backend::RandomGraph(seed, {.nodes = 100, .loop_closures = 80})));
    for (const bool new_structure : {true, false}) {
      const PoseMatrix matrix = RandomMatrix<3>(structure.blocks(), seed + new_structure);
      PoseMatrix::Vector x = RandomVector<3>(structure.blocks(), seed), y = x;
      ASSERT_TRUE(cholmod.Solve(structure.blocks(), matrix, new_structure, &x));
      ASSERT_TRUE(cholesky.Solve(structure.blocks(), structure.symbolic(), matrix, &y));
      EXPECT_LT((Dense(x) - Dense(y)).norm(), 1e-10 * Dense(y).norm());
    }
  }
}

TEST(CholmodSolver, RefusesMatricesThatAreNotPositiveDefinite) {
  GraphStructure structure;
  structure.Update(backend::IndexGraph(backend::RandomGraph(1)));
  PoseMatrix matrix = RandomMatrix<3>(structure.blocks(), 1);
  matrix.diagonal(7)(1, 1) = -1.0;
  PoseMatrix::Vector x = RandomVector<3>(structure.blocks(), 1);
  EXPECT_FALSE(CholmodSolver().Solve(structure.blocks(), matrix, true, &x));
}

}  // namespace
}  // namespace gmapping_spa::spa
