// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/block_structure.h"

#include <algorithm>

#include "backend/sparse/adjacency.h"
#include "backend/sparse/elimination_order.h"
#include "backend/sparse/elimination_tree.h"

namespace gmapping_spa::spa {
namespace {

using backend::GraphIndex;

// Appends the columns from `first_column` on and the slots of the edges not yet known.
void AppendBlocks(const GraphIndex& index, int first_column, BlockStructure* structure) {
  const std::size_t first_edge = structure->slot_of_edge.size();
  const Adjacency adjacency = MakeAdjacency(index, structure->column_of_node, first_edge,
                                            first_column, structure->columns());
  const int first_block = structure->blocks();
  structure->row.insert(structure->row.end(), adjacency.row.begin(), adjacency.row.end());
  for (std::size_t k = 1; k < adjacency.begin.size(); ++k) {
    structure->begin.push_back(first_block + adjacency.begin[k]);
  }
  structure->slot_of_edge.resize(index.edges.size());
  for (std::size_t e = first_edge; e < index.edges.size(); ++e) {
    const int i = structure->column_of_node[index.edges[e].i];
    const int j = structure->column_of_node[index.edges[e].j];
    if (i < 0 || j < 0 || i == j) continue;
    const auto first = structure->row.begin() + structure->begin[std::max(i, j)];
    const auto last = structure->row.begin() + structure->begin[std::max(i, j) + 1];
    const auto block = std::lower_bound(first, last, std::min(i, j));
    structure->slot_of_edge[e] = {static_cast<int>(block - structure->row.begin()), j < i};
  }
}

// The nodes that have a column, numbered as they come.
class FreeNodes {
 public:
  explicit FreeNodes(const GraphIndex& index) : number_of_node_(index.fixed.size(), -1) {
    for (int k = 0; k < static_cast<int>(index.fixed.size()); ++k) {
      if (index.fixed[k]) continue;
      number_of_node_[k] = static_cast<int>(nodes_.size());
      nodes_.push_back(k);
    }
  }

  Adjacency MakeAdjacency(const GraphIndex& index) const {
    return spa::MakeAdjacency(index, number_of_node_, 0, 0, static_cast<int>(nodes_.size()));
  }

  // The structure with these numbers as columns.
  BlockStructure InOrder(const GraphIndex& index, std::vector<int> order) const {
    for (int& number : order) number = nodes_[number];
    return spa::InOrder(index, order);
  }

 private:
  std::vector<int> number_of_node_;
  std::vector<int> nodes_;
};

}  // namespace

BlockStructure InOrder(const GraphIndex& index, const std::vector<int>& node_of_column) {
  BlockStructure structure;
  structure.node_of_column = node_of_column;
  structure.column_of_node.assign(index.fixed.size(), -1);
  for (int column = 0; column < structure.columns(); ++column) {
    structure.column_of_node[node_of_column[column]] = column;
  }
  structure.begin = {0};
  AppendBlocks(index, 0, &structure);
  return structure;
}

BlockStructure OrderByMinimumDegree(const GraphIndex& index) {
  const FreeNodes free(index);
  return free.InOrder(index, MinimumDegreeOrder(free.MakeAdjacency(index)));
}

BlockStructure OrderByNestedDissection(const GraphIndex& index) {
  const FreeNodes free(index);
  std::vector<int> order = NestedDissectionOrder(free.MakeAdjacency(index));
  EliminationTree tree;
  ExtendTree(free.InOrder(index, order), &tree);
  std::vector<int> postorder = Postorder(tree);
  for (int& column : postorder) column = order[column];
  return free.InOrder(index, postorder);
}

bool AppendNewNodes(const GraphIndex& index, BlockStructure* structure) {
  const int first_column = structure->columns();
  for (std::size_t node = structure->column_of_node.size(); node < index.fixed.size(); ++node) {
    structure->column_of_node.push_back(index.fixed[node] ? -1 : structure->columns());
    if (!index.fixed[node]) structure->node_of_column.push_back(static_cast<int>(node));
  }
  for (std::size_t e = structure->slot_of_edge.size(); e < index.edges.size(); ++e) {
    const int i = structure->column_of_node[index.edges[e].i];
    const int j = structure->column_of_node[index.edges[e].j];
    const bool both_free = i >= 0 && j >= 0 && i != j;
    if (both_free && std::max(i, j) < first_column) return false;
  }
  AppendBlocks(index, first_column, structure);
  return true;
}

}  // namespace gmapping_spa::spa
