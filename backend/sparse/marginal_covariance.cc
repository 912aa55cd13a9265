// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/marginal_covariance.h"

#include <algorithm>

namespace gmapping_spa::spa {
namespace {

constexpr int kSize = PoseMatrix::kSize;
constexpr std::size_t kNumbers = std::size_t{kSize} * kSize;

// A row of a block in one register; a fourth lane idles.
using Row = double __attribute__((vector_size(32), aligned(8)));

// The arrays of the recursion. Plain pointers, so that the loops below compile to the same
// instructions whatever surrounds them.
struct Arrays {
  const double* inverse_diagonal;
  const double* transposed;
  const int* row;
  double* diagonal;
  double* upper;
  Row* u;    // kSize rows for each block of the longest column: U_k
  Row* sum;  // likewise: sum over k of Sigma(i, k) U_k
};

// sum += block * x and sum += block' * x, for blocks by rows.
[[gnu::always_inline]] inline void AddProduct(const double* block, const Row* x, Row* sum) {
  for (int a = 0; a < kSize; ++a) {
    for (int c = 0; c < kSize; ++c) sum[a] += block[a * kSize + c] * x[c];
  }
}
[[gnu::always_inline]] inline void AddTransposedProduct(const double* block, const Row* x,
                                                        Row* sum) {
  for (int a = 0; a < kSize; ++a) {
    for (int c = 0; c < kSize; ++c) sum[a] += block[c * kSize + a] * x[c];
  }
}

// The blocks of column j, when those of all later columns are known.
[[gnu::always_inline]] inline void RecurColumn(const SymbolicFactor& symbolic, Arrays arrays,
                                               int j) {
  const int begin = symbolic.column_begin[j], count = symbolic.column_begin[j + 1] - begin;
  const double* const inverse = arrays.inverse_diagonal + kNumbers * j;
  for (int p = 0; p < count; ++p) {
    const double* const l = arrays.transposed + kNumbers * (begin + p);
    for (int a = 0; a < kSize; ++a) {
      Row u{};
      for (int c = 0; c < kSize; ++c) {
        for (int b = 0; b <= c; ++b) u[b] += l[c * kSize + a] * inverse[c * kSize + b];
      }
      arrays.u[kSize * p + a] = u;
      arrays.sum[kSize * p + a] = Row{};
    }
  }
  for (int p = 0; p < count; ++p) {
    const int k = arrays.row[begin + p];
    const Row* const u_k = arrays.u + std::ptrdiff_t{kSize} * p;
    Row sum[kSize];
    for (int a = 0; a < kSize; ++a) sum[a] = arrays.sum[kSize * p + a];
    AddProduct(arrays.diagonal + kNumbers * k, u_k, sum);
    // The later rows of this column are all in column k, too.
    int q = symbolic.column_begin[k];
    for (int r = p + 1; r < count; ++r, ++q) {
      while (arrays.row[q] != arrays.row[begin + r]) ++q;
      const double* const sigma = arrays.upper + kNumbers * q;
      AddProduct(sigma, arrays.u + std::ptrdiff_t{kSize} * r, sum);
      AddTransposedProduct(sigma, u_k, arrays.sum + std::ptrdiff_t{kSize} * r);
    }
    for (int a = 0; a < kSize; ++a) arrays.sum[kSize * p + a] = sum[a];
  }
  double diagonal[kSize][kSize] = {};
  for (int a = 0; a < kSize; ++a) {
    for (int b = 0; b < kSize; ++b) {
      for (int c = std::max(a, b); c < kSize; ++c) {
        diagonal[a][b] += inverse[c * kSize + a] * inverse[c * kSize + b];
      }
    }
  }
  for (int p = 0; p < count; ++p) {
    const Row* const u = arrays.u + std::ptrdiff_t{kSize} * p;
    const Row* const sum = arrays.sum + std::ptrdiff_t{kSize} * p;
    double* const sigma = arrays.upper + kNumbers * (begin + p);
    for (int a = 0; a < kSize; ++a) {
      for (int b = 0; b < kSize; ++b) {
        sigma[a * kSize + b] = -sum[b][a];
        for (int c = 0; c < kSize; ++c) diagonal[a][b] += sum[c][a] * u[c][b];
      }
    }
  }
  double* const sigma = arrays.diagonal + kNumbers * j;
  for (int a = 0; a < kSize; ++a) {
    for (int b = 0; b < kSize; ++b) {
      sigma[a * kSize + b] = 0.5 * (diagonal[a][b] + diagonal[b][a]);
    }
  }
}

[[gnu::always_inline]] inline void RecurColumns(const SymbolicFactor& symbolic, Arrays arrays) {
  for (int j = symbolic.columns() - 1; j >= 0; --j) RecurColumn(symbolic, arrays, j);
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] void RecurColumnsAvx2(const SymbolicFactor& symbolic, Arrays arrays) {
  RecurColumns(symbolic, arrays);
}
bool HasAvx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#endif

using Block = MarginalCovariance::Block;

Eigen::Map<const Block> BlockAt(const std::vector<double>& blocks, std::size_t position) {
  return Eigen::Map<const Block>(blocks.data() + kNumbers * position);
}

}  // namespace

std::int64_t MarginalCovariance::ProductsOfColumn(int a) const {
  std::int64_t products = 0;
  for (int k = a; k >= 0; k = tree_.parent[k]) {
    products += symbolic_.column_begin[k + 1] - symbolic_.column_begin[k];
  }
  return products;
}

void MarginalCovariance::Recur() {
  const std::size_t columns = symbolic_.columns(), blocks = symbolic_.column_begin.back();
  int longest = 0;
  for (std::size_t k = 0; k < columns; ++k) {
    longest = std::max(longest, symbolic_.column_begin[k + 1] - symbolic_.column_begin[k]);
  }
  diagonal_.resize(kNumbers * columns);
  upper_.resize(kNumbers * blocks);
  std::vector<double> work(std::size_t{2} * kSize * (sizeof(Row) / sizeof(double)) * longest);
  Row* const rows = reinterpret_cast<Row*>(work.data());
  const Arrays arrays{cholesky_.inverse_diagonal().data(),
                      cholesky_.transposed().data(),
                      cholesky_.row().data(),
                      diagonal_.data(),
                      upper_.data(),
                      rows,
                      rows + std::ptrdiff_t{kSize} * longest};
#if defined(__x86_64__)
  if (HasAvx2()) return RecurColumnsAvx2(symbolic_, arrays);
#endif
  RecurColumns(symbolic_, arrays);
}

// Where the factor has a block of the two columns; -1 if nowhere.
int MarginalCovariance::Find(int a, int b) const {
  const int column = std::min(a, b), row = std::max(a, b);
  const auto first = cholesky_.row().begin() + symbolic_.column_begin[column];
  const auto last = cholesky_.row().begin() + symbolic_.column_begin[column + 1];
  const auto found = std::lower_bound(first, last, row);
  return found == last || *found != row ? -1 : static_cast<int>(found - cholesky_.row().begin());
}

void MarginalCovariance::Substitute(int a, Column* column) const {
  std::vector<Block>& x = column->blocks;
  if (column->of < 0) x.assign(symbolic_.columns(), Block::Zero());
  for (int k = column->of; k >= 0; k = tree_.parent[k]) x[k].setZero();
  column->of = a;
  x[a].setIdentity();
  for (int k = a; k >= 0; k = tree_.parent[k]) {
    x[k] = BlockAt(cholesky_.inverse_diagonal(), k) * x[k];
    for (int q = symbolic_.column_begin[k]; q < symbolic_.column_begin[k + 1]; ++q) {
      x[cholesky_.row()[q]].noalias() -= BlockAt(cholesky_.transposed(), q).transpose() * x[k];
    }
  }
}

void MarginalCovariance::SetColumn(int a) {
  if (first_.of != a) Substitute(a, &first_);
}

Block MarginalCovariance::Of(int a, int b) {
  if (IsKnown(a, b)) {
    if (a == b) return BlockAt(diagonal_, a);
    const Eigen::Map<const Block> block = BlockAt(upper_, Find(a, b));
    return a < b ? Block(block) : Block(block.transpose());
  }
  if (b != a) Substitute(b, &second_);
  const Column& other = b == a ? first_ : second_;
  Block sum = Block::Zero();
  for (int k = b; k >= 0; k = tree_.parent[k]) {
    sum.noalias() += first_.blocks[k].transpose() * other.blocks[k];
  }
  return sum;
}

}  // namespace gmapping_spa::spa
