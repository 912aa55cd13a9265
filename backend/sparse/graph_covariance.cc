// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/graph_covariance.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "backend/sparse/marginal_covariance.h"

namespace gmapping_spa::spa {
namespace {

using backend::EdgeNodes;

// The pairs in columns instead of nodes; -1 for held ones.
std::vector<EdgeNodes> InColumns(std::span<const EdgeNodes> pairs, const BlockStructure& blocks) {
  std::vector<EdgeNodes> columns;
  columns.reserve(pairs.size());
  for (const EdgeNodes& pair : pairs) {
    columns.push_back({blocks.column_of_node[pair.i], blocks.column_of_node[pair.j]});
  }
  return columns;
}

// What it would take to compute the pairs, sorted by i, by columns of their own.
std::int64_t ProductsByColumns(const std::vector<EdgeNodes>& columns, const std::vector<int>& order,
                               const MarginalCovariance& covariance, std::int64_t up_to) {
  std::int64_t products = 0;
  int last = -1;
  for (const int k : order) {
    const auto [a, b] = columns[k];
    if (a < 0 || b < 0) continue;
    if (a != last) products += covariance.ProductsOfColumn(a);
    if (a != b) products += covariance.ProductsOfColumn(b);
    last = a;
    if (products > up_to) break;
  }
  return products;
}

}  // namespace

std::optional<std::vector<Eigen::Matrix3d>> CovariancesOf(const backend::PoseGraphView& graph,
                                                          std::span<const EdgeNodes> pairs,
                                                          const GraphStructure& structure,
                                                          NormalEquations* equations,
                                                          BlockCholesky* cholesky) {
  const BlockStructure& blocks = structure.blocks();
  Linearize(graph, structure.index(), blocks, PosesOf(graph), {}, equations);
  SymbolicFactor own;  // of large graphs, whose structure has fronts
  if (!structure.fronts().empty()) ExtendPattern(blocks, structure.tree(), &own);
  const SymbolicFactor& symbolic = structure.fronts().empty() ? structure.symbolic() : own;
  PoseMatrix::Vector no_right_side(blocks.columns(), PoseMatrix::Segment::Zero());
  if (!cholesky->Solve(blocks, symbolic, equations->hessian, &no_right_side)) {
    return std::nullopt;
  }
  const std::vector<EdgeNodes> columns = InColumns(pairs, blocks);
  std::vector<int> order(pairs.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return columns[k].i; });

  MarginalCovariance covariance(structure.tree(), symbolic, *cholesky);
  const std::int64_t recursion = covariance.ProductsOfRecursion();
  if (ProductsByColumns(columns, order, covariance, recursion) > recursion) covariance.Recur();
  std::vector<Eigen::Matrix3d> result(pairs.size(), Eigen::Matrix3d::Zero());
  for (const int k : order) {
    const auto [a, b] = columns[k];
    if (a < 0 || b < 0) continue;
    if (!covariance.IsKnown(a, b)) covariance.SetColumn(a);
    result[k] = covariance.Of(a, b);
  }
  return result;
}

}  // namespace gmapping_spa::spa
