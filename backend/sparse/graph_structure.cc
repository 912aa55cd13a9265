// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/graph_structure.h"

#include <algorithm>
#include <utility>

namespace gmapping_spa::spa {
namespace {

// A new ordering costs about as much as this many block products for each column of the matrix.
constexpr std::int64_t kOrderingProductsPerColumn = 60;

template <typename T>
bool IsPrefix(const std::vector<T>& prefix, const std::vector<T>& whole) {
  return prefix.size() <= whole.size() && std::equal(prefix.begin(), prefix.end(), whole.begin());
}

}  // namespace

void GraphStructure::Update(backend::GraphIndex index) {
  const bool grown = IsPrefix(index_.edges, index.edges) && IsPrefix(index_.fixed, index.fixed);
  const bool same = grown && index_.edges.size() == index.edges.size() &&
                    index_.fixed.size() == index.fixed.size();
  index_ = std::move(index);
  changed_ = !same || symbolic_.columns() == 0;
  if (!changed_) return;
  if (!grown || ordered_columns_ == 0 || !Append()) Reorder();
}

bool GraphStructure::Append() {
  if (!AppendNewNodes(index_, &blocks_)) return false;
  ExtendPattern(blocks_, &symbolic_);
  // The excess over the last ordering, scaled to the size of today, must stay below the cost of a
  // new one: then neither dominates.
  const std::int64_t expected = ordered_products_ * blocks_.columns() / ordered_columns_;
  return symbolic_.block_products - expected <
         kOrderingProductsPerColumn * std::int64_t{blocks_.columns()};
}

void GraphStructure::Reorder() {
  blocks_ = OrderByMinimumDegree(index_);
  symbolic_ = SymbolicFactor();
  ExtendPattern(blocks_, &symbolic_);
  ordered_products_ = symbolic_.block_products;
  ordered_columns_ = blocks_.columns();
}

}  // namespace gmapping_spa::spa
