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
  return cholesky_.Solve(structure.blocks(), structure.symbolic(), shifted_, x);
}

void LiftedSolver::Solve(const spa::GraphStructure& structure, LiftedVector* x) const {
  using Block = Eigen::Map<const LiftedMatrix::Block>;
  constexpr std::size_t kNumbers = std::size_t{LiftedMatrix::kSize} * LiftedMatrix::kSize;
  const spa::SymbolicFactor& symbolic = structure.symbolic();
  const double* const inverse = cholesky_.inverse_diagonal().data();
  const double* const transposed = cholesky_.transposed().data();
  const std::vector<int>& row = cholesky_.row();
  for (int k = 0; k < symbolic.columns(); ++k) {
    (*x)[k] = Block(inverse + kNumbers * k) * (*x)[k];
    for (int q = symbolic.column_begin[k]; q < symbolic.column_begin[k + 1]; ++q) {
      (*x)[row[q]] -= Block(transposed + kNumbers * q).transpose() * (*x)[k];
    }
  }
  for (int k = symbolic.columns() - 1; k >= 0; --k) {
    LiftedMatrix::Segment y = (*x)[k];
    for (int q = symbolic.column_begin[k]; q < symbolic.column_begin[k + 1]; ++q) {
      y -= Block(transposed + kNumbers * q) * (*x)[row[q]];
    }
    (*x)[k] = Block(inverse + kNumbers * k).transpose() * y;
  }
}

}  // namespace gmapping_spa::backend
