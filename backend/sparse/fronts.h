// SPDX-License-Identifier: BSD-3-Clause
// Symbolic multifrontal Cholesky factorization: columns that are eliminated together.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_FRONTS_H_
#define GMAPPING_SPA_BACKEND_SPARSE_FRONTS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "backend/sparse/elimination_tree.h"

namespace gmapping_spa::spa {

// Columns of L one after the other whose patterns below them are alike, or nearly so, held as one
// dense matrix: the pivots, and the rows below them.
struct Front {
  int first = 0;        // pivot
  int pivots = 0;       // how many
  int row_begin = 0;    // of its part of Fronts::row
  int rows = 0;         // below the pivots
  int entry_begin = 0;  // of its part of Fronts::entry
  int entries = 0;
  int parent = -1;        // the front of its first row; -1 for roots
  int first_child = -1;   // -1: none
  int next_child = -1;    // of the same parent
  std::int64_t work = 0;  // block products of it and all fronts below it
};

// A block of the matrix above the diagonal whose row is a pivot of the front.
struct FrontEntry {
  int block = 0;   // see BlockStructure::row
  int column = 0;  // of that block
};

struct Fronts {
  std::vector<Front> fronts;  // children before their parents
  std::vector<int> row;       // columns of the matrix, ascending in each front
  std::vector<FrontEntry> entry;

  bool empty() const { return fronts.empty(); }
};

// Makes fronts of all columns. Small ones are merged with their parents where that adds few zeros,
// as CHOLMOD does (Chen, Davis, Hager, Rajamanickam 2008).
Fronts FindFronts(const BlockStructure& structure, const EliminationTree& tree);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_FRONTS_H_
