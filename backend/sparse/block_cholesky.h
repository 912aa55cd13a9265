// SPDX-License-Identifier: BSD-3-Clause
// Sparse Cholesky factorization of a matrix of small dense blocks.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_BLOCK_CHOLESKY_H_
#define GMAPPING_SPA_BACKEND_SPARSE_BLOCK_CHOLESKY_H_

#include <vector>

#include "backend/sparse/block_matrix.h"
#include "backend/sparse/symbolic_factor.h"

namespace gmapping_spa::spa {

// Up-looking A = L L' (Davis 2006, section 4.7), on blocks instead of numbers. The pattern is
// walked once for kSize^2 numbers and the inner loop is a product of blocks whose size the compiler
// knows: that is where the speed comes from on pose graphs, whose supernodes are small.
//
// Solve is instantiated for kSize 2 to 4. One object serves all in turn and keeps its memory: on
// graphs of this size, getting memory from the system takes as long as a factorization.
class BlockCholesky {
 public:
  // Replaces the right-hand side `x` (one block for each column) by the solution. Returns false,
  // with `x` undefined, when the matrix is not positive definite.
  template <int kSize>
  bool Solve(const BlockStructure& structure, const SymbolicFactor& symbolic,
             const BlockMatrix<kSize>& matrix, typename BlockMatrix<kSize>::Vector* x);

  // The factor L of the matrix that Solve last returned true for: the inverse of each block on the
  // diagonal, and below it the blocks L(k, i)' of column i, in the places that
  // SymbolicFactor::column_begin says, k ascending, with the k of each. Blocks are kSize^2 numbers
  // by rows.
  const std::vector<double>& inverse_diagonal() const { return inverse_diagonal_; }
  const std::vector<double>& transposed() const { return transposed_; }
  const std::vector<int>& row() const { return row_; }

 private:
  std::vector<double> inverse_diagonal_;  // blocks of L, inverted
  std::vector<double> transposed_;        // blocks L(k, i)' in column i of L, k ascending
  std::vector<int> row_;                  // k of each of them
  std::vector<int> end_;                  // of the part of each column that is known
  std::vector<double> work_;
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_BLOCK_CHOLESKY_H_
