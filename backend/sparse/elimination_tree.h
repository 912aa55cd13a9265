// SPDX-License-Identifier: BSD-3-Clause
// Which columns of the Cholesky factor change which others.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_ELIMINATION_TREE_H_
#define GMAPPING_SPA_BACKEND_SPARSE_ELIMINATION_TREE_H_

#include <cstdint>
#include <vector>

#include "backend/sparse/block_structure.h"

namespace gmapping_spa::spa {

// The elimination tree of A = L L' (Davis, Direct Methods for Sparse Linear Systems, 2006, section
// 4.1): the parent of a column is the first row below the diagonal in that column of L.
struct EliminationTree {
  std::vector<int> parent;          // of each column; -1 for roots
  std::vector<int> count;           // of each column's blocks in L below the diagonal
  std::int64_t block_products = 0;  // that a factorization takes

  int columns() const { return static_cast<int>(parent.size()); }
};

// Adds the columns of `structure` that `tree`, made for the columns before them, lacks.
void ExtendTree(const BlockStructure& structure, EliminationTree* tree);

// The columns so that each comes right before its parent, or before other columns below its parent.
std::vector<int> Postorder(const EliminationTree& tree);

// Calls visit(column) for each column in the row k of L, left of the diagonal, in no order.
// `visited_by` has one number for each column, none of them k.
template <typename Visit>
void ForEachInRow(const BlockStructure& structure, const std::vector<int>& parent, int k,
                  std::vector<int>* visited_by, const Visit& visit) {
  (*visited_by)[k] = k;
  for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
    // Every column on the way from a row of A up to k is in the row k of L.
    for (int i = structure.row[p]; (*visited_by)[i] != k; i = parent[i]) {
      (*visited_by)[i] = k;
      visit(i);
    }
  }
}

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_ELIMINATION_TREE_H_
