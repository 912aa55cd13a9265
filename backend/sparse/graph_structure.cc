// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/graph_structure.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace gmapping_spa::spa {
namespace {

// A new ordering costs about as much as this many block products for each column of the matrix.
constexpr std::int64_t kOrderingProductsPerColumn = 150;
// From this many on, nested dissection costs less than what it may save in some factorizations.
constexpr std::int64_t kDissectionProductsPerColumn = 300;
// From this many on, the factor does not fit into the caches of a processor.
constexpr std::int64_t kFrontsProducts = 50'000'000;
// Days of work; multiplied by the columns of any graph that fits into memory it does not overflow.
constexpr std::int64_t kMostProducts = 1'000'000'000'000;

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
  changed_ = !same || tree_.columns() == 0;
  if (!changed_) return;
  if (!grown || ordered_columns_ == 0 || !Append()) Reorder();
  Analyze();
}

bool GraphStructure::Append() {
  if (!AppendNewNodes(index_, &blocks_)) return false;
  ExtendTree(blocks_, &tree_);
  // The excess over the last ordering, scaled to the size of today, summed over the factorizations
  // since then, must stay below the cost of a new one: then neither dominates.
  const std::int64_t expected = ordered_products_ * blocks_.columns() / ordered_columns_;
  excess_products_ += std::max<std::int64_t>(tree_.block_products - expected, 0);
  return excess_products_ < kOrderingProductsPerColumn * blocks_.columns();
}

void GraphStructure::Reorder() {
  blocks_ = OrderByMinimumDegree(index_);
  tree_ = EliminationTree();
  ExtendTree(blocks_, &tree_);
  if (tree_.block_products > kDissectionProductsPerColumn * blocks_.columns()) {
    BlockStructure dissected = OrderByNestedDissection(index_);
    EliminationTree tree;
    ExtendTree(dissected, &tree);
    if (tree.block_products < tree_.block_products) {
      blocks_ = std::move(dissected);
      tree_ = std::move(tree);
    }
  }
  symbolic_ = SymbolicFactor();
  ordered_products_ = tree_.block_products;
  ordered_columns_ = blocks_.columns();
  excess_products_ = 0;
}

void GraphStructure::Analyze() {
  fronts_ = Fronts();
  if (tree_.block_products < kFrontsProducts) {
    ExtendPattern(blocks_, tree_, &symbolic_);
  } else {
    symbolic_ = SymbolicFactor();
    fronts_ = FindFronts(blocks_, tree_);
  }
}

void GraphStructure::Save(backend::PacketWriter* packet) const {
  packet->Put(index_.edges.size());
  packet->PutAll(std::span(index_.edges));
  packet->Put(index_.fixed.size());
  for (const bool fixed : index_.fixed) packet->Put(fixed);
  packet->PutAll(std::span(blocks_.node_of_column));  // as many as are not fixed
  packet->Put(ordered_products_);
  packet->Put(ordered_columns_);
  packet->Put(excess_products_);
}

void GraphStructure::Load(backend::PacketReader* packet) {
  const auto take_size = [packet](std::size_t bytes) {
    const auto size = packet->Take<std::size_t>();
    packet->CheckRoom(size, bytes);
    return size;
  };
  *this = GraphStructure();
  index_.edges.resize(take_size(sizeof(backend::EdgeNodes)));
  packet->TakeAll(std::span(index_.edges));
  index_.fixed.resize(take_size(1));
  std::vector<int> free;
  for (std::size_t node = 0; node < index_.fixed.size(); ++node) {
    index_.fixed[node] = packet->Take<std::uint8_t>() != 0;
    if (!index_.fixed[node]) free.push_back(static_cast<int>(node));
  }
  std::vector<int> order(free.size());
  packet->TakeAll(std::span(order));
  ordered_products_ = packet->Take<std::int64_t>();
  ordered_columns_ = packet->Take<int>();
  excess_products_ = packet->Take<std::int64_t>();
  const auto is_node = [this](int node) {
    return node >= 0 && node < static_cast<int>(index_.fixed.size());
  };
  const auto is_count = [](std::int64_t count) { return count >= 0 && count <= kMostProducts; };
  if (ordered_columns_ < 0 || ordered_columns_ > static_cast<int>(free.size()) ||
      !is_count(ordered_products_) || !is_count(excess_products_)) {
    throw backend::MalformedPacket("what an ordering of another graph takes");
  }
  std::vector<int> sorted = order;
  std::ranges::sort(sorted);
  if (sorted != free || !std::ranges::all_of(index_.edges, [&](const backend::EdgeNodes& edge) {
        return is_node(edge.i) && is_node(edge.j);
      })) {
    throw backend::MalformedPacket("an ordering of another graph");
  }
  if (index_.fixed.empty()) return;  // there was no graph yet
  blocks_ = InOrder(index_, order);
  ExtendTree(blocks_, &tree_);
  Analyze();
}

}  // namespace gmapping_spa::spa
