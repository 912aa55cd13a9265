// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/block_cholesky.h"

#include <cmath>

namespace gmapping_spa::spa {
namespace {

// A row of a block in one register: with 3 numbers, a fourth lane idles.
template <int kSize>
struct RowOf;
template <>
struct RowOf<2> {
  using Type = double __attribute__((vector_size(16), aligned(8)));
  static constexpr int kLanes = 2;
};
template <>
struct RowOf<4> {
  // Not aligned beyond double, since it lives in a std::vector<double>.
  using Type = double __attribute__((vector_size(32), aligned(8)));
  static constexpr int kLanes = 4;
};
template <>
struct RowOf<3> : RowOf<4> {};

// Inverts the factor of a diagonal block (its upper triangle is read). False when the block is not
// positive definite.
template <int kSize>
[[gnu::always_inline]] inline bool InvertFactor(const double* block, int stride, double* inverse) {
  double l[kSize][kSize] = {};
  for (int k = 0; k < kSize * kSize; ++k) inverse[k] = 0.0;
  for (int c = 0; c < kSize; ++c) {
    const double diagonal = block[c * stride + c];
    double pivot = diagonal;
    for (int k = 0; k < c; ++k) pivot -= l[c][k] * l[c][k];
    // NaN fails too. A pivot that is all cancellation is no pivot.
    if (!(pivot > 1e-14 * diagonal) || !std::isfinite(pivot)) return false;
    l[c][c] = std::sqrt(pivot);
    inverse[c * kSize + c] = 1.0 / l[c][c];
    for (int r = c + 1; r < kSize; ++r) {
      double sum = block[c * stride + r];
      for (int k = 0; k < c; ++k) sum -= l[r][k] * l[c][k];
      l[r][c] = sum * inverse[c * kSize + c];
    }
  }
  for (int c = 0; c < kSize; ++c) {
    for (int r = c + 1; r < kSize; ++r) {
      double sum = 0.0;
      for (int k = c; k < r; ++k) sum -= l[r][k] * inverse[k * kSize + c];
      inverse[r * kSize + c] = sum * inverse[r * kSize + r];
    }
  }
  return true;
}

// y -= s' x for blocks by rows; s is packed.
template <int kSize, typename Row>
[[gnu::always_inline]] inline void SubtractProduct(const double* s, const Row* x, Row* y) {
  for (int a = 0; a < kSize; ++a) {
    Row sum = y[a];
    for (int c = 0; c < kSize; ++c) sum -= s[c * kSize + a] * x[c];
    y[a] = sum;
  }
}

// The arrays of BlockCholesky. Plain pointers, so that the loops below compile to the same
// instructions whatever surrounds them.
struct Arrays {
  const double* diagonal;
  const double* off_diagonal;
  double* inverse_diagonal;
  double* transposed;
  int* row;
  int* end;
  double* work;  // zero, kSize rows of kLanes for each column
  double* x;     // the right-hand side, then the solution
};

// Factorizes row by row. Each row of L is at hand when it is complete, so that forward substitution
// goes along at no cost: x becomes L^-1 x.
template <int kSize>
[[gnu::always_inline]] inline bool FactorizeRows(const BlockStructure& structure,
                                                 const SymbolicFactor& symbolic, Arrays arrays) {
  using Row = typename RowOf<kSize>::Type;
  constexpr std::size_t kNumbers = std::size_t{kSize} * kSize;
  constexpr int kLanes = RowOf<kSize>::kLanes;
  Row* const work = reinterpret_cast<Row*>(arrays.work);
  const int columns = structure.columns();
  for (int k = 0; k < columns; ++k) {
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      Row* const to = work + std::size_t{kSize} * structure.row[p];
      const double* const off_diagonal = arrays.off_diagonal + kNumbers * p;
      for (int a = 0; a < kSize; ++a) {
        for (int b = 0; b < kSize; ++b) to[a][b] = off_diagonal[a * kSize + b];
      }
    }
    Row pivot[kSize] = {};
    const double* const diagonal = arrays.diagonal + kNumbers * k;
    for (int a = 0; a < kSize; ++a) {
      for (int b = 0; b < kSize; ++b) pivot[a][b] = diagonal[a * kSize + b];
    }
    double* const right = arrays.x + std::size_t{kSize} * k;
    Row rest{};
    for (int b = 0; b < kSize; ++b) rest[b] = right[b];
    // Solves L(0:k, 0:k) X = A(0:k, k), block by block; X' is row k of L.
    for (int p = symbolic.row_begin[k]; p < symbolic.row_begin[k + 1]; ++p) {
      const int i = symbolic.row_pattern[p];
      const double* const inverse = arrays.inverse_diagonal + kNumbers * i;
      Row* const y = work + std::size_t{kSize} * i;
      Row x[kSize];
      for (int a = kSize - 1; a >= 0; --a) {
        const double* const row = inverse + std::ptrdiff_t{kSize} * a;
        x[a] = row[0] * y[0];
        for (int c = 1; c <= a; ++c) x[a] += row[c] * y[c];
      }
      for (int a = 0; a < kSize; ++a) y[a] = Row{};
      const int end = arrays.end[i];
      for (int q = symbolic.column_begin[i]; q < end; ++q) {
        SubtractProduct<kSize>(arrays.transposed + kNumbers * q, x,
                               work + std::size_t{kSize} * arrays.row[q]);
      }
      double* const stored = arrays.transposed + kNumbers * end;
      for (int a = 0; a < kSize; ++a) {
        for (int b = 0; b < kSize; ++b) stored[a * kSize + b] = x[a][b];
      }
      SubtractProduct<kSize>(stored, x, pivot);
      for (int a = 0; a < kSize; ++a) rest -= arrays.x[std::size_t{kSize} * i + a] * x[a];
      arrays.row[end] = k;
      arrays.end[i] = end + 1;
    }
    double* const inverse = arrays.inverse_diagonal + kNumbers * k;
    if (!InvertFactor<kSize>(reinterpret_cast<const double*>(pivot), kLanes, inverse)) {
      return false;
    }
    for (int a = 0; a < kSize; ++a) {
      double sum = 0.0;
      for (int c = 0; c <= a; ++c) sum += inverse[a * kSize + c] * rest[c];
      right[a] = sum;
    }
  }
  return true;
}

// Back substitution: x becomes L'^-1 x.
template <int kSize>
[[gnu::always_inline]] inline void SubstituteBack(const SymbolicFactor& symbolic, Arrays arrays) {
  constexpr std::size_t kNumbers = std::size_t{kSize} * kSize;
  for (int k = symbolic.columns() - 1; k >= 0; --k) {
    double* const x = arrays.x + std::size_t{kSize} * k;
    double y[kSize];
    for (int a = 0; a < kSize; ++a) y[a] = x[a];
    for (int q = symbolic.column_begin[k]; q < symbolic.column_begin[k + 1]; ++q) {
      const double* const block = arrays.transposed + kNumbers * q;
      const double* const known = arrays.x + std::size_t{kSize} * arrays.row[q];
      for (int a = 0; a < kSize; ++a) {
        for (int b = 0; b < kSize; ++b) y[a] -= block[a * kSize + b] * known[b];
      }
    }
    const double* const inverse = arrays.inverse_diagonal + kNumbers * k;
    for (int a = 0; a < kSize; ++a) {
      x[a] = 0.0;
      for (int c = a; c < kSize; ++c) x[a] += inverse[c * kSize + a] * y[c];
    }
  }
}

template <int kSize>
[[gnu::always_inline]] inline bool SolveRows(const BlockStructure& structure,
                                             const SymbolicFactor& symbolic, Arrays arrays) {
  if (!FactorizeRows<kSize>(structure, symbolic, arrays)) return false;
  SubstituteBack<kSize>(symbolic, arrays);
  return true;
}

#if defined(__x86_64__)
template <int kSize>
[[gnu::target("avx2,fma")]] bool SolveRowsAvx2(const BlockStructure& structure,
                                               const SymbolicFactor& symbolic, Arrays arrays) {
  return SolveRows<kSize>(structure, symbolic, arrays);
}
bool HasAvx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#endif

}  // namespace

template <int kSize>
bool BlockCholesky::Solve(const BlockStructure& structure, const SymbolicFactor& symbolic,
                          const BlockMatrix<kSize>& matrix,
                          typename BlockMatrix<kSize>::Vector* x) {
  const std::size_t columns = structure.columns(), blocks = symbolic.column_begin.back();
  inverse_diagonal_.reserve(columns * kLargestSize * kLargestSize);
  transposed_.reserve(blocks * kLargestSize * kLargestSize);
  work_.reserve(columns * kLargestSize * RowOf<kLargestSize>::kLanes);
  inverse_diagonal_.resize(columns * kSize * kSize);
  transposed_.resize(blocks * kSize * kSize);
  row_.resize(blocks);
  end_.assign(symbolic.column_begin.begin(), symbolic.column_begin.end() - 1);
  work_.assign(columns * kSize * RowOf<kSize>::kLanes, 0.0);
  const Arrays arrays{matrix.diagonal_data(),
                      matrix.off_diagonal_data(),
                      inverse_diagonal_.data(),
                      transposed_.data(),
                      row_.data(),
                      end_.data(),
                      work_.data(),
                      reinterpret_cast<double*>(x->data())};
#if defined(__x86_64__)
  if (HasAvx2()) return SolveRowsAvx2<kSize>(structure, symbolic, arrays);
#endif
  return SolveRows<kSize>(structure, symbolic, arrays);
}

template <int kSize>
void BlockCholesky::SolveAgain(const SymbolicFactor& symbolic,
                               typename BlockMatrix<kSize>::Vector* x) const {
  using Block = Eigen::Map<const typename BlockMatrix<kSize>::Block>;
  constexpr std::size_t kNumbers = std::size_t{kSize} * kSize;
  const auto inverse = [&](int k) { return Block(inverse_diagonal_.data() + kNumbers * k); };
  const auto transposed = [&](int q) { return Block(transposed_.data() + kNumbers * q); };
  for (int k = 0; k < symbolic.columns(); ++k) {
    (*x)[k] = inverse(k) * (*x)[k];
    for (int q = symbolic.column_begin[k]; q < symbolic.column_begin[k + 1]; ++q) {
      (*x)[row_[q]] -= transposed(q).transpose() * (*x)[k];
    }
  }
  for (int k = symbolic.columns() - 1; k >= 0; --k) {
    typename BlockMatrix<kSize>::Segment y = (*x)[k];
    for (int q = symbolic.column_begin[k]; q < symbolic.column_begin[k + 1]; ++q) {
      y -= transposed(q) * (*x)[row_[q]];
    }
    (*x)[k] = inverse(k).transpose() * y;
  }
}

template bool BlockCholesky::Solve(const BlockStructure&, const SymbolicFactor&,
                                   const BlockMatrix<2>&, BlockMatrix<2>::Vector*);
template bool BlockCholesky::Solve(const BlockStructure&, const SymbolicFactor&,
                                   const BlockMatrix<3>&, BlockMatrix<3>::Vector*);
template bool BlockCholesky::Solve(const BlockStructure&, const SymbolicFactor&,
                                   const BlockMatrix<4>&, BlockMatrix<4>::Vector*);
template void BlockCholesky::SolveAgain<3>(const SymbolicFactor&, BlockMatrix<3>::Vector*) const;
template void BlockCholesky::SolveAgain<4>(const SymbolicFactor&, BlockMatrix<4>::Vector*) const;

}  // namespace gmapping_spa::spa
