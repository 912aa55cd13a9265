// SPDX-License-Identifier: BSD-3-Clause
// Symbolic Cholesky factorization: the pattern of the factor.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_SYMBOLIC_FACTOR_H_
#define GMAPPING_SPA_BACKEND_SPARSE_SYMBOLIC_FACTOR_H_

#include <vector>

#include "backend/sparse/elimination_tree.h"

namespace gmapping_spa::spa {

// The pattern of the factor L of A = L L', below the diagonal, by rows and by columns.
struct SymbolicFactor {
  std::vector<int> row_begin = {0};     // of each row's entries in row_pattern; size columns + 1
  std::vector<int> row_pattern;         // columns, ascending
  std::vector<int> column_begin = {0};  // of each column's blocks; size columns + 1

  int columns() const { return static_cast<int>(row_begin.size()) - 1; }
};

// Adds the rows of `structure`, whose tree is `tree`, that `factor`, made for the rows before them,
// lacks.
void ExtendPattern(const BlockStructure& structure, const EliminationTree& tree,
                   SymbolicFactor* factor);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_SYMBOLIC_FACTOR_H_
