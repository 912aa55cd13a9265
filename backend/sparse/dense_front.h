// SPDX-License-Identifier: BSD-3-Clause
// Dense arithmetic of one front.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_DENSE_FRONT_H_
#define GMAPPING_SPA_BACKEND_SPARSE_DENSE_FRONT_H_

namespace gmapping_spa::spa {

// Made for the instructions that the processor has. `panel` is a column-major matrix of `rows` rows
// and `pivots` columns (numbers) whose upper triangle is not used; `columns` are the same without
// that triangle: each from the diagonal on, one after the other.
struct DenseFront {
  // Makes columns of the matrix columns of L. False when the matrix is not positive definite.
  bool (*factorize)(double* panel, int rows, int pivots);
  // Subtracts what the columns of L change in the rest of the matrix: the lower triangle of
  // `update`, with rows - pivots rows.
  void (*update)(const double* panel, int rows, int pivots, double* update);
  // Forward substitution on x, with `rows` numbers: those of the pivots become the solution, what
  // they contribute is subtracted from the others.
  void (*substitute)(const double* columns, int rows, int pivots, double* x);
  // Back substitution: those of the pivots become the solution, the others are known.
  void (*substitute_back)(const double* columns, int rows, int pivots, double* x);
};

const DenseFront& DenseFrontForThisProcessor();

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_DENSE_FRONT_H_
