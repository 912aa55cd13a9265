// SPDX-License-Identifier: BSD-3-Clause
// Linear systems in the positions and rotations of the free nodes.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_SOLVER_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_SOLVER_H_

#include "backend/certificate/dual_problem.h"
#include "backend/sparse/sparse_cholesky.h"

namespace gmapping_spa::backend {

// A Cholesky factor that serves many right-hand sides.
class LiftedSolver {
 public:
  // Factorizes the matrix + shift diag(0, 0, 1, 1) of each node - margin times its diagonal, and
  // replaces `x` by the solution. False, with `x` undefined, when that is not positive definite.
  bool FactorizeAndSolve(const spa::GraphStructure& structure, const LiftedMatrix& matrix,
                         double shift, double margin, LiftedVector* x);

  // Replaces another `x` by its solution with the last factor.
  void Solve(const spa::GraphStructure& structure, LiftedVector* x) const;

 private:
  LiftedMatrix shifted_;
  spa::SparseCholesky cholesky_;
};

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_SOLVER_H_
