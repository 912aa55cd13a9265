// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/cholmod_solver.h"

#include <suitesparse/cholmod.h>

#include <algorithm>
#include <new>

namespace gmapping_spa::spa {
namespace {

constexpr int kSize = PoseMatrix::kSize;

}  // namespace

struct CholmodSolver::Workspace {
  cholmod_common common;
  cholmod_sparse* matrix = nullptr;
  cholmod_factor* factor = nullptr;

  Workspace() {
    cholmod_start(&common);
    common.print = 0;  // a matrix that is not positive definite is no news to the caller
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_NATURAL;
    common.postorder = true;
    common.final_ll = true;  // its LDL' would take indefinite matrices
  }
  ~Workspace() {
    Clear();
    cholmod_finish(&common);
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  void Clear() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_sparse(&matrix, &common);
  }

  // Makes the upper triangle of the scalar matrix: kSize columns for each column of blocks, each
  // with the rows of the blocks above and its part of the diagonal block.
  void SetPattern(const BlockStructure& structure) {
    Clear();
    const std::size_t size = std::size_t{kSize} * structure.columns();
    const std::size_t entries = std::size_t{kSize} * kSize * structure.blocks() +
                                std::size_t{kSize} * (kSize + 1) / 2 * structure.columns();
    matrix = cholmod_allocate_sparse(size, size, entries, /*sorted=*/true, /*packed=*/true,
                                     /*stype=*/1, CHOLMOD_REAL, &common);
    if (matrix == nullptr) throw std::bad_alloc();
    int* const begin = static_cast<int*>(matrix->p);
    int* const row = static_cast<int*>(matrix->i);
    int entry = 0;
    for (int k = 0; k < structure.columns(); ++k) {
      for (int c = 0; c < kSize; ++c) {
        begin[kSize * k + c] = entry;
        for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
          for (int r = 0; r < kSize; ++r) row[entry++] = kSize * structure.row[p] + r;
        }
        for (int r = 0; r <= c; ++r) row[entry++] = kSize * k + r;
      }
    }
    begin[size] = entry;
    factor = cholmod_analyze(matrix, &common);
    if (factor == nullptr) throw std::bad_alloc();
  }

  void SetValues(const BlockStructure& structure, const PoseMatrix& blocks) const {
    double* value = static_cast<double*>(matrix->x);
    for (int k = 0; k < structure.columns(); ++k) {
      for (int c = 0; c < kSize; ++c) {
        for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
          for (int r = 0; r < kSize; ++r) *value++ = blocks.off_diagonal(p)(r, c);
        }
        for (int r = 0; r <= c; ++r) *value++ = blocks.diagonal(k)(r, c);
      }
    }
  }
};

CholmodSolver::CholmodSolver() : workspace_(std::make_unique<Workspace>()) {}
CholmodSolver::~CholmodSolver() = default;

bool CholmodSolver::Solve(const BlockStructure& structure, const PoseMatrix& matrix,
                          bool new_structure, PoseMatrix::Vector* x) {
  if (structure.columns() == 0) return true;
  Workspace& w = *workspace_;
  if (new_structure || w.matrix == nullptr) w.SetPattern(structure);
  w.SetValues(structure, matrix);
  if (!cholmod_factorize(w.matrix, w.factor, &w.common) || w.common.status != CHOLMOD_OK) {
    if (w.common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    return false;
  }
  const std::size_t numbers = kSize * x->size();
  cholmod_dense* right =
      cholmod_allocate_dense(w.matrix->nrow, 1, w.matrix->nrow, CHOLMOD_REAL, &w.common);
  if (right == nullptr) throw std::bad_alloc();
  std::copy_n(x->data()->data(), numbers, static_cast<double*>(right->x));
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, w.factor, right, &w.common);
  cholmod_free_dense(&right, &w.common);
  if (solution == nullptr) throw std::bad_alloc();
  std::copy_n(static_cast<const double*>(solution->x), numbers, x->data()->data());
  cholmod_free_dense(&solution, &w.common);
  return true;
}

}  // namespace gmapping_spa::spa
