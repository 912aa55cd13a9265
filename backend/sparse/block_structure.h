// SPDX-License-Identifier: BSD-3-Clause
// Where the blocks of the normal equations and of their Cholesky factor are.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_BLOCK_STRUCTURE_H_
#define GMAPPING_SPA_BACKEND_SPARSE_BLOCK_STRUCTURE_H_

#include <vector>

#include "backend/graph/graph_index.h"

namespace gmapping_spa::spa {

// The pattern of a symmetric matrix of square blocks, one row and column for each free node, in
// elimination order. The blocks above the diagonal are held by columns.
struct BlockStructure {
  // Where the off-diagonal block of an edge goes. The block d2/(d i d j) is stored as it is, or
  // transposed when j is eliminated before i.
  struct Slot {
    int block = -1;  // -1: an end of the edge is held, or both ends are the same node
    bool transposed = false;
  };

  std::vector<int> column_of_node;  // elimination position of each node; -1 for held ones
  std::vector<int> node_of_column;
  std::vector<int> begin;  // of each column's blocks; size columns + 1
  std::vector<int> row;    // of each block, below its column
  std::vector<Slot> slot_of_edge;

  int columns() const { return static_cast<int>(node_of_column.size()); }
  int blocks() const { return static_cast<int>(row.size()); }
};

// Orders the free nodes for elimination (elimination_order.h).
BlockStructure OrderByMinimumDegree(const backend::GraphIndex& index);
BlockStructure OrderByNestedDissection(const backend::GraphIndex& index);

// The structure with the free nodes, each of which is there once, as columns.
BlockStructure InOrder(const backend::GraphIndex& index, const std::vector<int>& node_of_column);

// Appends to the order of `structure`, made for the first nodes and edges of the same graph, the
// free ones of the nodes that came since, and the blocks of the edges that came since. Returns
// false, with `structure` undefined, when one of those edges connects two earlier nodes.
bool AppendNewNodes(const backend::GraphIndex& index, BlockStructure* structure);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_BLOCK_STRUCTURE_H_
