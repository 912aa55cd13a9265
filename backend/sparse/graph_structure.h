// SPDX-License-Identifier: BSD-3-Clause
// The ordering and the symbolic factorization of a graph, kept while the graph grows.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_GRAPH_STRUCTURE_H_
#define GMAPPING_SPA_BACKEND_SPARSE_GRAPH_STRUCTURE_H_

#include <cstdint>

#include "backend/graph/graph_index.h"
#include "backend/sparse/block_structure.h"
#include "backend/sparse/symbolic_factor.h"

namespace gmapping_spa::spa {

class GraphStructure {
 public:
  // Makes the structure that of `index`. A graph that is as before costs a comparison; one that has
  // only grown keeps its ordering, new nodes last, until the factor would take too much more work
  // than the last minimum-degree ordering promised.
  void Update(backend::GraphIndex index);

  const backend::GraphIndex& index() const { return index_; }
  const BlockStructure& blocks() const { return blocks_; }
  const SymbolicFactor& symbolic() const { return symbolic_; }
  // Whether the last Update changed the structure.
  bool changed() const { return changed_; }

 private:
  bool Append();
  void Reorder();

  backend::GraphIndex index_;
  BlockStructure blocks_;
  SymbolicFactor symbolic_;
  // What the last minimum-degree ordering achieved.
  std::int64_t ordered_products_ = 0;
  int ordered_columns_ = 0;
  bool changed_ = false;
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_GRAPH_STRUCTURE_H_
