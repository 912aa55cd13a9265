// SPDX-License-Identifier: BSD-3-Clause
// The sparse Cholesky factorization that fits a graph.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_SPARSE_CHOLESKY_H_
#define GMAPPING_SPA_BACKEND_SPARSE_SPARSE_CHOLESKY_H_

#include "backend/sparse/block_cholesky.h"
#include "backend/sparse/graph_structure.h"
#include "backend/sparse/multifrontal_cholesky.h"

namespace gmapping_spa::spa {

class SparseCholesky {
 public:
  // How many threads large graphs may use. The solution does not depend on it.
  void set_threads(int threads) { threads_ = threads; }

  // Replaces the right-hand side `x` (one block for each column) by the solution. Returns false,
  // with `x` undefined, when the matrix is not positive definite.
  template <int kSize>
  bool Solve(const GraphStructure& structure, const BlockMatrix<kSize>& matrix,
             typename BlockMatrix<kSize>::Vector* x) {
    if (structure.fronts().empty()) {
      return rows_.Solve(structure.blocks(), structure.symbolic(), matrix, x);
    }
    return fronts_.Solve(structure.blocks(), structure.fronts(), matrix, threads_, x);
  }

  // Replaces another right-hand side `x` by the solution, with the factor of the last Solve, which
  // has returned true and was of this size and structure.
  template <int kSize>
  void SolveAgain(const GraphStructure& structure, typename BlockMatrix<kSize>::Vector* x) const {
    if (structure.fronts().empty()) {
      rows_.SolveAgain<kSize>(structure.symbolic(), x);
    } else {
      fronts_.SolveAgain<kSize>(structure.fronts(), x);
    }
  }

  // For what needs the factor itself, row by row.
  BlockCholesky& by_rows() { return rows_; }

 private:
  BlockCholesky rows_;
  MultifrontalCholesky fronts_;
  int threads_ = 1;
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_SPARSE_CHOLESKY_H_
