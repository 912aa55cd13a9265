// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/lifted_solver.h"

namespace gmapping_spa::backend {

bool LiftedSolver::FactorizeAndSolve(const spa::GraphStructure& structure,
                                     const LiftedMatrix& matrix, double shift, double margin,
                                     LiftedVector* x) {
  shifted_ = matrix;
  for (int k = 0; k < structure.blocks().columns(); ++k) {
    auto diagonal = shifted_.diagonal(k).diagonal();
    diagonal *= 1.0 - margin;
    diagonal.tail<2>().array() += shift;
  }
  return cholesky_.Solve(structure, shifted_, x);
}

void LiftedSolver::Solve(const spa::GraphStructure& structure, LiftedVector* x) const {
  cholesky_.SolveAgain<LiftedMatrix::kSize>(structure, x);
}

}  // namespace gmapping_spa::backend
