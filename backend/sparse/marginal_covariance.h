// SPDX-License-Identifier: BSD-3-Clause
// Blocks of the inverse of a sparse matrix, from its Cholesky factor.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_MARGINAL_COVARIANCE_H_
#define GMAPPING_SPA_BACKEND_SPARSE_MARGINAL_COVARIANCE_H_

#include <cstdint>
#include <vector>

#include "backend/sparse/block_cholesky.h"
#include "backend/sparse/block_matrix.h"
#include "backend/sparse/symbolic_factor.h"

namespace gmapping_spa::spa {

// The blocks Sigma(a, b) of Sigma = A^-1 for a factorized A = L L' of pose blocks; with A the
// Hessian of a pose graph, Sigma is the covariance of its free nodes. No other part of Sigma, which
// is dense, is ever made:
//
//   - On the pattern of L, from the last column to the first (Takahashi, Fagan, Chen 1973; for
//     graphs of poses Kaess and Dellaert 2009, "Covariance recovery from a square root information
//     matrix for data association", and Ila et al. 2017): with U_k = L(k, j) L(j, j)^-1 and sums
//     over the rows k of column j,
//       Sigma(i, j) = -sum Sigma(i, k) U_k,   Sigma(j, j) = (L L')(j, j)^-1 - sum Sigma(j, k) U_k,
//     which needs no blocks but those on the pattern. It takes twice the products of a
//     factorization, in the memory of another factor.
//   - Elsewhere Sigma(a, b) = W_a' W_b with W_a = L^-1 E_a, which is zero but for a and what is
//     above it in the elimination tree.
class MarginalCovariance {
 public:
  using Block = PoseMatrix::Block;

  // All stay as they are while the object is used: `cholesky` has factorized a PoseMatrix whose
  // factor has the pattern `symbolic`, and `tree` is its elimination tree.
  MarginalCovariance(const EliminationTree& tree, const SymbolicFactor& symbolic,
                     const BlockCholesky& cholesky)
      : tree_(tree), symbolic_(symbolic), cholesky_(cholesky) {}

  // Products of blocks that the recursion takes, and those of a column W_a.
  std::int64_t ProductsOfRecursion() const { return 2 * tree_.block_products; }
  std::int64_t ProductsOfColumn(int a) const;

  // Makes all blocks on the pattern.
  void Recur();

  // Makes W_a, for blocks of the column a that are not on the pattern or come without recursion.
  void SetColumn(int a);

  // Sigma(a, b), where a is that of the last SetColumn unless IsKnown(a, b).
  Block Of(int a, int b);

  // Whether Recur has made the block.
  bool IsKnown(int a, int b) const { return !diagonal_.empty() && (a == b || Find(a, b) >= 0); }

 private:
  // W_a: `blocks`, one for each column, is zero but for those above a.
  struct Column {
    int of = -1;
    std::vector<Block> blocks;
  };

  int Find(int a, int b) const;
  void Substitute(int a, Column* column) const;

  const EliminationTree& tree_;
  const SymbolicFactor& symbolic_;
  const BlockCholesky& cholesky_;
  std::vector<double> diagonal_;  // blocks Sigma(j, j)
  std::vector<double> upper_;     // blocks Sigma(j, k), where the factor has L(k, j)
  Column first_, second_;
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_MARGINAL_COVARIANCE_H_
