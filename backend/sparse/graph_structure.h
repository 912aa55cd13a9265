// SPDX-License-Identifier: BSD-3-Clause
// The ordering and the symbolic factorization of a graph, kept while the graph grows.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_GRAPH_STRUCTURE_H_
#define GMAPPING_SPA_BACKEND_SPARSE_GRAPH_STRUCTURE_H_

#include <cstdint>

#include "backend/graph/graph_index.h"
#include "backend/packet.h"
#include "backend/sparse/block_structure.h"
#include "backend/sparse/elimination_tree.h"
#include "backend/sparse/fronts.h"
#include "backend/sparse/symbolic_factor.h"

namespace gmapping_spa::spa {

class GraphStructure {
 public:
  // Makes the structure that of `index`. A graph that is as before costs a comparison; one that has
  // only grown keeps its ordering, new nodes last, until that took as much more work than the last
  // ordering promised as a new one costs. Large graphs are ordered by nested dissection where that
  // takes less work.
  void Update(backend::GraphIndex index);

  const backend::GraphIndex& index() const { return index_; }
  const BlockStructure& blocks() const { return blocks_; }
  const EliminationTree& tree() const { return tree_; }
  // The one that SparseCholesky uses; the other is empty. Fronts pay in large graphs.
  const SymbolicFactor& symbolic() const { return symbolic_; }
  const Fronts& fronts() const { return fronts_; }
  // Whether the last Update changed the structure.
  bool changed() const { return changed_; }

  // All that later calls of Update depend on: the index and the ordering, of which the rest is made
  // again. Load throws backend::MalformedPacket when the packet is none of Save.
  void Save(backend::PacketWriter* packet) const;
  void Load(backend::PacketReader* packet);

 private:
  bool Append();
  void Reorder();
  void Analyze();

  backend::GraphIndex index_;
  BlockStructure blocks_;
  EliminationTree tree_;
  SymbolicFactor symbolic_;
  Fronts fronts_;
  // What the last ordering achieved.
  std::int64_t ordered_products_ = 0;
  int ordered_columns_ = 0;
  std::int64_t excess_products_ = 0;  // what appended columns cost since
  bool changed_ = false;
};

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_GRAPH_STRUCTURE_H_
