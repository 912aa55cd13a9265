// SPDX-License-Identifier: BSD-3-Clause
// The functions of DenseFront, compiled once for each set of instructions: what includes this
// defines the namespace that they are in. No include guard, and no other source includes it.
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>

#include "backend/sparse/dense_front.h"

namespace gmapping_spa::spa::GMAPPING_SPA_KERNELS {

// Up to this many rows, loops are faster than the blocked algorithms of Eigen.
inline constexpr int kFewRows = 40;

using Panel = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstPanel = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

// a -= factor b, for the entries from `begin` to `end`.
static inline void Subtract(double factor, const double* b, int begin, int end, double* a) {
  for (int i = begin; i < end; ++i) a[i] -= factor * b[i];
}

static bool Factorize(double* panel, int rows, int pivots) {
  if (rows > kFewRows) {
    Panel top(panel, pivots, pivots, Eigen::OuterStride<>(rows));
    Panel below(panel + pivots, rows - pivots, pivots, Eigen::OuterStride<>(rows));
    Eigen::LLT<Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>> llt(top);
    if (llt.info() != Eigen::Success) return false;
    if (rows > pivots) {
      top.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
    }
    return true;
  }
  for (int j = 0; j < pivots; ++j) {
    double* const column = panel + static_cast<std::ptrdiff_t>(rows) * j;
    if (!(column[j] > 0.0)) return false;
    const double inverse = 1.0 / std::sqrt(column[j]);
    for (int i = j; i < rows; ++i) column[i] *= inverse;
    for (int c = j + 1; c < pivots; ++c) {
      Subtract(column[c], column, c, rows, panel + static_cast<std::ptrdiff_t>(rows) * c);
    }
  }
  return true;
}

static void Update(const double* panel, int rows, int pivots, double* update) {
  const int rest = rows - pivots;
  if (rows > kFewRows) {
    const ConstPanel below(panel + pivots, rest, pivots, Eigen::OuterStride<>(rows));
    Eigen::Map<Eigen::MatrixXd>(update, rest, rest)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(below, -1.0);
    return;
  }
  for (int j = 0; j < pivots; ++j) {
    const double* const column = panel + static_cast<std::ptrdiff_t>(rows) * j + pivots;
    for (int c = 0; c < rest; ++c) {
      Subtract(column[c], column, c, rest, update + static_cast<std::ptrdiff_t>(rest) * c);
    }
  }
}

static void Substitute(const double* columns, int rows, int pivots, double* x) {
  const double* column = columns;
  for (int j = 0; j < pivots; ++j) {
    x[j] /= column[0];
    Subtract(x[j], column + 1, 0, rows - j - 1, x + j + 1);
    column += rows - j;
  }
}

static void SubstituteBack(const double* columns, int rows, int pivots, double* x) {
  const std::ptrdiff_t size =
      std::ptrdiff_t{pivots} * rows - std::ptrdiff_t{pivots} * (pivots - 1) / 2;
  const double* column = columns + size;
  for (int j = pivots - 1; j >= 0; --j) {
    column -= rows - j;
    const int below = rows - j - 1;
    const double known = Eigen::Map<const Eigen::VectorXd>(column + 1, below)
                             .dot(Eigen::Map<const Eigen::VectorXd>(x + j + 1, below));
    x[j] = (x[j] - known) / column[0];
  }
}

extern const DenseFront kDenseFront;
const DenseFront kDenseFront = {Factorize, Update, Substitute, SubstituteBack};

}  // namespace gmapping_spa::spa::GMAPPING_SPA_KERNELS
