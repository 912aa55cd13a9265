// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/elimination_tree.h"

#include <gtest/gtest.h>

#include "tests/backend/random_graph.h"
#include "tests/backend/sparse/dense.h"

namespace gmapping_spa::spa {
namespace {

TEST(ExtendTree, IsThatOfTheDenseFactor) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const BlockStructure structure =
        OrderByMinimumDegree(backend::IndexGraph(backend::RandomGraph(seed)));
    EliminationTree tree;
    ExtendTree(structure, &tree);
    const Eigen::MatrixXd l = Dense(structure, RandomMatrix<2>(structure, seed)).llt().matrixL();
    std::int64_t products = 0;
    for (int i = 0; i < structure.columns(); ++i) {
      std::vector<int> below;
      for (int k = i + 1; k < structure.columns(); ++k) {
        if (l.block<2, 2>(2 * k, 2 * i).norm() > 1e-13) below.push_back(k);
      }
      const auto count = static_cast<int>(below.size());
      EXPECT_EQ(tree.count[i], count);
      EXPECT_EQ(tree.parent[i], below.empty() ? -1 : below.front());
      products += count * (count + 1) / 2;
    }
    EXPECT_EQ(tree.block_products, products);
  }
}

TEST(ExtendTree, AddsNewColumnsToTheSameEnd) {
  const BlockStructure whole = OrderByMinimumDegree(backend::IndexGraph(backend::RandomGraph(3)));
  BlockStructure part = whole;
  part.node_of_column.resize(12);
  part.begin.resize(13);
  EliminationTree in_two_steps, at_once;
  ExtendTree(part, &in_two_steps);
  ExtendTree(whole, &in_two_steps);
  ExtendTree(whole, &at_once);
  EXPECT_EQ(in_two_steps.parent, at_once.parent);
  EXPECT_EQ(in_two_steps.count, at_once.count);
  EXPECT_EQ(in_two_steps.block_products, at_once.block_products);
}

TEST(Postorder, PutsTheColumnsBelowEachColumnRightBeforeIt) {
  EliminationTree tree;
  tree.parent = {4, 3, 4, 5, 5, -1, 7, -1};
  EXPECT_EQ(Postorder(tree), (std::vector<int>{1, 3, 0, 2, 4, 5, 6, 7}));
}

}  // namespace
}  // namespace gmapping_spa::spa
