// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/symbolic_factor.h"

#include <gtest/gtest.h>

#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

TEST(ExtendPattern, FindsTheEntriesOfTheDenseFactor) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const BlockStructure structure =
        OrderByMinimumDegree(backend::IndexGraph(backend::RandomGraph(seed)));
    EliminationTree tree;
    ExtendTree(structure, &tree);
    SymbolicFactor factor;
    ExtendPattern(structure, tree, &factor);
    const Eigen::MatrixXd l = Dense(structure, RandomMatrix<2>(structure, seed)).llt().matrixL();
    for (int k = 0; k < structure.columns(); ++k) {
      std::vector<int> row;
      for (int i = 0; i < k; ++i) {
        if (l.block<2, 2>(2 * k, 2 * i).norm() > 1e-13) row.push_back(i);
      }
      EXPECT_EQ(row, std::vector<int>(factor.row_pattern.begin() + factor.row_begin[k],
                                      factor.row_pattern.begin() + factor.row_begin[k + 1]));
      EXPECT_EQ(factor.column_begin[k + 1] - factor.column_begin[k], tree.count[k]);
    }
  }
}

TEST(ExtendPattern, AnalysesNewRowsAloneToTheSameEnd) {
  const BlockStructure whole = OrderByMinimumDegree(backend::IndexGraph(backend::RandomGraph(3)));
  BlockStructure part = whole;
  part.node_of_column.resize(12);
  part.begin.resize(13);
  EliminationTree tree;
  SymbolicFactor in_two_steps, at_once;
  ExtendTree(part, &tree);
  ExtendPattern(part, tree, &in_two_steps);
  ExtendTree(whole, &tree);
  ExtendPattern(whole, tree, &in_two_steps);
  ExtendPattern(whole, tree, &at_once);
  EXPECT_EQ(in_two_steps.row_pattern, at_once.row_pattern);
  EXPECT_EQ(in_two_steps.row_begin, at_once.row_begin);
  EXPECT_EQ(in_two_steps.column_begin, at_once.column_begin);
}

}  // namespace
}  // namespace gmapping_spa::spa
