// SPDX-License-Identifier: BSD-3-Clause
// Symbolic Cholesky factorization: the pattern of the factor.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_SYMBOLIC_FACTOR_H_
#define GMAPPING_SPA_BACKEND_SPARSE_SYMBOLIC_FACTOR_H_

#include <cstdint>
#include <vector>

#include "backend/sparse/block_structure.h"

namespace gmapping_spa::spa {

// The pattern of the factor L of A = L L', below the diagonal, by rows and by columns. Rows are
// found as the reach of a column of A in the elimination tree (Davis, Direct Methods for Sparse
// Linear Systems, 2006, section 4.1).
struct SymbolicFactor {
  std::vector<int> row_begin = {0};     // of each row's entries in row_pattern; size columns + 1
  std::vector<int> row_pattern;         // columns, ascending
  std::vector<int> column_begin = {0};  // of each column's blocks; size columns + 1
  std::vector<int> parent;              // of each column in the elimination tree; -1 for roots
  std::int64_t block_products = 0;      // that a factorization takes

  int columns() const { return static_cast<int>(parent.size()); }
};

// Analyses the columns of `structure` that `factor`, made for the columns before them, lacks.
void ExtendPattern(const BlockStructure& structure, SymbolicFactor* factor);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_SYMBOLIC_FACTOR_H_
