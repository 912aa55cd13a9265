// SPDX-License-Identifier: BSD-3-Clause
// Sparse Cholesky factorization by dense matrices, for large graphs.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_MULTIFRONTAL_CHOLESKY_H_
#define GMAPPING_SPA_BACKEND_SPARSE_MULTIFRONTAL_CHOLESKY_H_

#include <vector>

#include "backend/sparse/block_matrix.h"
#include "backend/sparse/fronts.h"

namespace gmapping_spa::spa {

// A = L L' front by front (Duff and Reid 1983): a front adds up its part of A and what its children
// left, eliminates its pivots, and leaves the rest to its parent. Where many columns are alike,
// dense arithmetic is several times as fast as BlockCholesky, which waits for memory there.
class MultifrontalCholesky {
 public:
  // Fronts that do not depend on each other are factorized by up to `threads` threads; the result
  // does not depend on how many there are. Else like BlockCholesky::Solve.
  template <int kSize>
  bool Solve(const BlockStructure& structure, const Fronts& fronts,
             const BlockMatrix<kSize>& matrix, int threads, typename BlockMatrix<kSize>::Vector* x);

  // Replaces another right-hand side `x` by the solution, with the factor of the last Solve, which
  // has returned true and was of this size.
  template <int kSize>
  void SolveAgain(const Fronts& fronts, typename BlockMatrix<kSize>::Vector* x) const;

 private:
  std::vector<double> factor_;      // the columns of L from the diagonal on, front by front
  std::vector<std::size_t> begin_;  // of each front's part of it
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_MULTIFRONTAL_CHOLESKY_H_
