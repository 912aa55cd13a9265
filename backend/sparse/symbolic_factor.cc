// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/symbolic_factor.h"

#include <algorithm>

namespace gmapping_spa::spa {

void ExtendPattern(const BlockStructure& structure, SymbolicFactor* factor) {
  const int columns = structure.columns(), first = factor->columns();
  std::vector<int>& parent = factor->parent;
  parent.resize(columns, -1);
  std::vector<int> visited_by(columns, -1);
  for (int k = first; k < columns; ++k) {
    visited_by[k] = k;
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      // Every column on the way from a row of A up to k is in the row k of L.
      for (int i = structure.row[p]; visited_by[i] != k; i = parent[i]) {
        if (parent[i] < 0) parent[i] = k;
        visited_by[i] = k;
        factor->row_pattern.push_back(i);
      }
    }
    std::sort(factor->row_pattern.begin() + factor->row_begin[k], factor->row_pattern.end());
    factor->row_begin.push_back(static_cast<int>(factor->row_pattern.size()));
  }
  std::vector<int> count(columns, 0);
  for (const int column : factor->row_pattern) ++count[column];
  factor->column_begin.resize(columns + 1);
  factor->block_products = 0;
  for (int k = 0; k < columns; ++k) {
    factor->column_begin[k + 1] = factor->column_begin[k] + count[k];
    factor->block_products += std::int64_t{count[k]} * (count[k] + 1) / 2;
  }
}

}  // namespace gmapping_spa::spa
