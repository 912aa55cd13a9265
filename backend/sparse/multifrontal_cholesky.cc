// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/multifrontal_cholesky.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <utility>

#include "backend/sparse/dense_front.h"

namespace gmapping_spa::spa {
namespace {

// Subtrees of fronts that threads take have at most one part of these, for each thread, of all
// work: small ones balance the threads, large ones leave less behind in memory.
constexpr int kPartsOfThread = 4;

template <int kSize>
class Factorization {
 public:
  Factorization(const BlockStructure& structure, const Fronts& fronts,
                const BlockMatrix<kSize>& matrix, const std::vector<std::size_t>& begin,
                double* factor)
      : structure_(structure),
        fronts_(fronts),
        matrix_(matrix),
        begin_(begin),
        factor_(factor),
        updates_(fronts.fronts.size()) {}

  // False when the matrix is not positive definite.
  bool Run(int threads) {
    // One thread alone goes from child to parent, which takes the least memory.
    is_done_.assign(Count(), false);
    const std::vector<int> subtrees =
        threads > 1 ? Subtrees(kPartsOfThread * threads) : std::vector<int>();
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> is_good = true;
    const auto work = [&] {
      Workspace workspace(structure_.columns());
      for (std::size_t k; is_good && (k = next++) < subtrees.size();) {
        if (!FactorizeSubtree(subtrees[k], &workspace)) is_good = false;
      }
    };
    {
      std::vector<std::jthread> others;
      for (int k = 1; k < threads; ++k) others.emplace_back(work);
      work();
    }
    Workspace workspace(structure_.columns());
    for (int f = 0; is_good && f < Count(); ++f) {
      if (!is_done_[f]) is_good = FactorizeFront(f, &workspace);
    }
    return is_good;
  }

 private:
  // What a thread needs for one front after the other.
  struct Workspace {
    explicit Workspace(int columns) : position(columns) {}
    std::vector<int> position;  // of each column in the front
    std::vector<double> panel;  // the columns of the pivots, with all rows
  };

  int Count() const { return static_cast<int>(fronts_.fronts.size()); }

  template <typename Visit>
  void ForEachChild(int front, const Visit& visit) const {
    for (int c = fronts_.fronts[front].first_child; c >= 0; c = fronts_.fronts[c].next_child) {
      visit(c);
    }
  }

  // The roots of the largest subtrees that have at most one of so many parts of all work, those
  // with most of it first. Marks what is in them.
  std::vector<int> Subtrees(int parts) {
    std::int64_t work = 0;
    for (const Front& front : fronts_.fronts) work += front.parent < 0 ? front.work : 0;
    const auto is_small = [&](int f) { return fronts_.fronts[f].work <= work / parts; };
    std::vector<int> roots;
    for (int f = Count() - 1; f >= 0; --f) {
      const int parent = fronts_.fronts[f].parent;
      is_done_[f] = (parent >= 0 && is_done_[parent]) || is_small(f);
      if (is_done_[f] && (parent < 0 || !is_done_[parent])) roots.push_back(f);
    }
    std::ranges::stable_sort(roots, std::greater<>(),
                             [&](int f) { return fronts_.fronts[f].work; });
    return roots;
  }

  bool FactorizeSubtree(int root, Workspace* workspace) {
    std::vector<int> below = {root};  // parents before their children
    for (std::size_t k = 0; k < below.size(); ++k) {
      ForEachChild(below[k], [&](int child) { below.push_back(child); });
    }
    std::ranges::sort(below);
    return std::ranges::all_of(below, [&](int f) { return FactorizeFront(f, workspace); });
  }

  bool FactorizeFront(int number, Workspace* workspace) {
    const Front& front = fronts_.fronts[number];
    const int* const rows = fronts_.row.data() + front.row_begin;
    std::vector<int>& position = workspace->position;
    for (int k = 0; k < front.pivots; ++k) position[front.first + k] = k;
    for (int k = 0; k < front.rows; ++k) position[rows[k]] = front.pivots + k;
    const int all = kSize * (front.pivots + front.rows), pivots = kSize * front.pivots;
    workspace->panel.assign(static_cast<std::size_t>(all) * pivots, 0.0);
    double* const panel = workspace->panel.data();
    AddMatrix(front, position, panel);
    std::vector<double>& update = updates_[number];
    update.assign(std::size_t{kSize} * kSize * front.rows * front.rows, 0.0);
    ForEachChild(number, [&](int child) { AddUpdate(child, front, position, panel, &update); });

    if (!dense_.factorize(panel, all, pivots) || !AreSound(front, panel)) return false;
    if (front.rows > 0) dense_.update(panel, all, pivots, update.data());
    double* to = factor_ + begin_[number];
    for (int j = 0; j < pivots; ++j) {
      to = std::copy_n(panel + (std::ptrdiff_t{all} + 1) * j, all - j, to);
    }
    return true;
  }

  void AddMatrix(const Front& front, const std::vector<int>& position, double* panel) const {
    const std::ptrdiff_t stride = std::ptrdiff_t{kSize} * (front.pivots + front.rows);
    for (int k = 0; k < front.pivots; ++k) {
      const auto block = matrix_.diagonal(front.first + k);
      double* const to = panel + (stride + 1) * kSize * k;
      for (int a = 0; a < kSize; ++a) {
        for (int b = 0; b < kSize; ++b) to[stride * b + a] = block(a, b);
      }
    }
    for (int e = 0; e < front.entries; ++e) {
      const FrontEntry& entry = fronts_.entry[front.entry_begin + e];
      const auto block = matrix_.off_diagonal(entry.block);
      double* const to = panel + stride * kSize * position[structure_.row[entry.block]] +
                         std::ptrdiff_t{kSize} * position[entry.column];
      for (int a = 0; a < kSize; ++a) {
        for (int b = 0; b < kSize; ++b) to[stride * a + b] = block(a, b);
      }
    }
  }

  // Adds what the child left to the front, and frees it.
  void AddUpdate(int child, const Front& front, const std::vector<int>& position, double* panel,
                 std::vector<double>* update) {
    const Front& from = fronts_.fronts[child];
    const int* const rows = fronts_.row.data() + from.row_begin;
    const std::vector<double> values = std::move(updates_[child]);
    const std::ptrdiff_t stride = std::ptrdiff_t{kSize} * from.rows;
    const std::ptrdiff_t panel_stride = std::ptrdiff_t{kSize} * (front.pivots + front.rows);
    const std::ptrdiff_t update_stride = std::ptrdiff_t{kSize} * front.rows;
    for (int b = 0; b < from.rows; ++b) {
      const int column = position[rows[b]];
      const bool is_pivot = column < front.pivots;
      const std::ptrdiff_t to_stride = is_pivot ? panel_stride : update_stride;
      // Of the column's blocks, as if they began with that of the first pivot.
      double* const to = is_pivot
                             ? panel + panel_stride * kSize * column
                             : update->data() + update_stride * kSize * (column - front.pivots) -
                                   std::ptrdiff_t{kSize} * front.pivots;
      for (int c = 0; c < kSize; ++c) {
        const double* const value = values.data() + stride * (kSize * b + c);
        double* const sum = to + to_stride * c;
        for (int a = b; a < from.rows; ++a) {
          double* const block = sum + std::ptrdiff_t{kSize} * position[rows[a]];
          for (int r = 0; r < kSize; ++r) block[r] += value[kSize * a + r];
        }
      }
    }
  }

  // A pivot that is all cancellation is no pivot; neither is one that is not finite.
  bool AreSound(const Front& front, const double* panel) const {
    const std::ptrdiff_t stride = std::ptrdiff_t{kSize} * (front.pivots + front.rows);
    for (int k = 0; k < front.pivots; ++k) {
      const auto block = matrix_.diagonal(front.first + k);
      for (int a = 0; a < kSize; ++a) {
        const double pivot = panel[(stride + 1) * (kSize * k + a)];
        if (!(pivot * pivot > 1e-14 * block(a, a)) || !std::isfinite(pivot)) return false;
      }
    }
    return true;
  }

  const BlockStructure& structure_;
  const Fronts& fronts_;
  const BlockMatrix<kSize>& matrix_;
  const std::vector<std::size_t>& begin_;
  double* factor_;
  std::vector<std::vector<double>> updates_;  // what each front left to its parent
  std::vector<bool> is_done_;                 // of each front, whether it is in one of Subtrees
  const DenseFront& dense_ = DenseFrontForThisProcessor();
};

// Calls use(columns of L, rows, pivots, x of these rows) for a front, and puts its x back.
template <int kSize, typename Use>
void WithRowsOf(const Front& front, const Fronts& fronts, const double* columns, double* x,
                std::vector<double>* local, const Use& use) {
  const int pivots = kSize * front.pivots, rows = kSize * front.rows;
  const int* const row = fronts.row.data() + front.row_begin;
  double* const first = x + std::ptrdiff_t{kSize} * front.first;
  local->resize(pivots + rows);
  std::copy_n(first, pivots, local->data());
  for (int k = 0; k < rows; ++k) (*local)[pivots + k] = x[kSize * row[k / kSize] + k % kSize];
  use(columns, pivots + rows, pivots, local->data());
  std::copy_n(local->data(), pivots, first);
  for (int k = 0; k < rows; ++k) x[kSize * row[k / kSize] + k % kSize] = (*local)[pivots + k];
}

}  // namespace

template <int kSize>
bool MultifrontalCholesky::Solve(const BlockStructure& structure, const Fronts& fronts,
                                 const BlockMatrix<kSize>& matrix, int threads,
                                 typename BlockMatrix<kSize>::Vector* x) {
  begin_ = {0};
  for (const Front& front : fronts.fronts) {
    const std::size_t pivots = std::size_t{kSize} * front.pivots;
    const std::size_t rows = pivots + std::size_t{kSize} * front.rows;
    begin_.push_back(begin_.back() + pivots * rows - pivots * (pivots - 1) / 2);
  }
  if (begin_.back() > factor_.capacity()) {
    std::vector<double>().swap(factor_);  // before there is more
  }
  factor_.resize(begin_.back());
  Factorization<kSize> factorization(structure, fronts, matrix, begin_, factor_.data());
  if (!factorization.Run(threads)) return false;
  SolveAgain<kSize>(fronts, x);
  return true;
}

template <int kSize>
void MultifrontalCholesky::SolveAgain(const Fronts& fronts,
                                      typename BlockMatrix<kSize>::Vector* x) const {
  const DenseFront& dense = DenseFrontForThisProcessor();
  auto* const numbers = reinterpret_cast<double*>(x->data());
  std::vector<double> local;
  const int count = static_cast<int>(fronts.fronts.size());
  const auto use = [&](int f, const auto& substitute) {
    WithRowsOf<kSize>(fronts.fronts[f], fronts, factor_.data() + begin_[f], numbers, &local,
                      substitute);
  };
  for (int f = 0; f < count; ++f) use(f, dense.substitute);
  for (int f = count - 1; f >= 0; --f) use(f, dense.substitute_back);
}

template bool MultifrontalCholesky::Solve(const BlockStructure&, const Fronts&,
                                          const BlockMatrix<2>&, int, BlockMatrix<2>::Vector*);
template bool MultifrontalCholesky::Solve(const BlockStructure&, const Fronts&,
                                          const BlockMatrix<3>&, int, BlockMatrix<3>::Vector*);
template bool MultifrontalCholesky::Solve(const BlockStructure&, const Fronts&,
                                          const BlockMatrix<4>&, int, BlockMatrix<4>::Vector*);
template void MultifrontalCholesky::SolveAgain<3>(const Fronts&, BlockMatrix<3>::Vector*) const;
template void MultifrontalCholesky::SolveAgain<4>(const Fronts&, BlockMatrix<4>::Vector*) const;

}  // namespace gmapping_spa::spa
