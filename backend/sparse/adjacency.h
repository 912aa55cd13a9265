// SPDX-License-Identifier: BSD-3-Clause
// The graph of the blocks of a symmetric matrix.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_ADJACENCY_H_
#define GMAPPING_SPA_BACKEND_SPARSE_ADJACENCY_H_

#include <vector>

#include "backend/graph/graph_index.h"

namespace gmapping_spa::spa {

// The pairs of columns that edges connect, each once: for each column its rows above the diagonal,
// ascending.
struct Adjacency {
  std::vector<int> begin;  // of each column's rows; size columns + 1
  std::vector<int> row;

  int columns() const { return static_cast<int>(begin.size()) - 1; }
};

// Of the columns from `first_column` on, which alone are in the result, and the edges from
// `first_edge` on. Nodes without a column (-1) and edges of a node with itself are left out.
Adjacency MakeAdjacency(const backend::GraphIndex& index, const std::vector<int>& column_of_node,
                        std::size_t first_edge, int first_column, int columns);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_ADJACENCY_H_
