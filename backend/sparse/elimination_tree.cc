// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/elimination_tree.h"

namespace gmapping_spa::spa {

void ExtendTree(const BlockStructure& structure, EliminationTree* tree) {
  const int columns = structure.columns(), first = tree->columns();
  tree->parent.resize(columns, -1);
  tree->count.resize(columns, 0);
  std::vector<int> visited_by(columns, -1);
  for (int k = first; k < columns; ++k) {
    ForEachInRow(structure, tree->parent, k, &visited_by, [&](int i) {
      if (tree->parent[i] < 0) tree->parent[i] = k;
      tree->block_products += ++tree->count[i];
    });
  }
}

std::vector<int> Postorder(const EliminationTree& tree) {
  const int columns = tree.columns();
  // Lists of children in ascending order, with the roots as children of a column of their own.
  std::vector<int> first_child(columns + 1, -1), next_child(columns, -1);
  for (int k = columns - 1; k >= 0; --k) {
    const int parent = tree.parent[k] < 0 ? columns : tree.parent[k];
    next_child[k] = first_child[parent];
    first_child[parent] = k;
  }
  std::vector<int> order, path = {columns};
  order.reserve(columns);
  while (!path.empty()) {
    const int column = path.back(), child = first_child[column];
    if (child >= 0) {
      first_child[column] = next_child[child];
      path.push_back(child);
    } else {
      path.pop_back();
      if (column < columns) order.push_back(column);
    }
  }
  return order;
}

}  // namespace gmapping_spa::spa
