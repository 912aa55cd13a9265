// SPDX-License-Identifier: BSD-3-Clause
// CHOLMOD on the normal equations.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_CHOLMOD_SOLVER_H_
#define GMAPPING_SPA_BACKEND_SPARSE_CHOLMOD_SOLVER_H_

#include <memory>

#include "backend/sparse/block_matrix.h"

namespace gmapping_spa::spa {

// Hands the matrix, already in elimination order, to CHOLMOD as numbers; CHOLMOD chooses between
// its simplicial and its supernodal factorization.
class CholmodSolver {
 public:
  CholmodSolver();
  ~CholmodSolver();

  // Replaces the right-hand side `x` (one block for each column) by the solution. Returns false,
  // with `x` as it was, when the matrix is not positive definite. `new_structure` says that the
  // pattern may differ from that of the call before.
  bool Solve(const BlockStructure& structure, const PoseMatrix& matrix, bool new_structure,
             PoseMatrix::Vector* x);

 private:
  struct Workspace;  // CHOLMOD's types
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_CHOLMOD_SOLVER_H_
