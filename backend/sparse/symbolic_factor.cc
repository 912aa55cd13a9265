// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/symbolic_factor.h"

#include <algorithm>

namespace gmapping_spa::spa {

void ExtendPattern(const BlockStructure& structure, const EliminationTree& tree,
                   SymbolicFactor* factor) {
  const int columns = structure.columns();
  std::vector<int> visited_by(columns, -1);
  for (int k = factor->columns(); k < columns; ++k) {
    ForEachInRow(structure, tree.parent, k, &visited_by,
                 [&](int i) { factor->row_pattern.push_back(i); });
    std::sort(factor->row_pattern.begin() + factor->row_begin[k], factor->row_pattern.end());
    factor->row_begin.push_back(static_cast<int>(factor->row_pattern.size()));
  }
  factor->column_begin.resize(columns + 1);
  for (int k = 0; k < columns; ++k) {
    factor->column_begin[k + 1] = factor->column_begin[k] + tree.count[k];
  }
}

}  // namespace gmapping_spa::spa
