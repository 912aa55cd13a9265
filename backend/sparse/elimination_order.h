// SPDX-License-Identifier: BSD-3-Clause
// In which order columns are eliminated, so that the factor has few blocks.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_ELIMINATION_ORDER_H_
#define GMAPPING_SPA_BACKEND_SPARSE_ELIMINATION_ORDER_H_

#include <vector>

#include "backend/sparse/adjacency.h"

namespace gmapping_spa::spa {

// Both work on the graph of blocks (a third of the rows of the scalar matrix, a ninth of its
// entries, and the same fill), and return the columns in the order of their elimination.

// Approximate minimum degree (Amestoy et al. 2004): fast, and best for graphs of usual sizes.
std::vector<int> MinimumDegreeOrder(const Adjacency& adjacency);

// Nested dissection (George 1973) by METIS (Karypis and Kumar 1998), after the stretches without
// loop closures, where each pose has two neighbors at most, are eliminated: slower, and with less
// fill in large graphs.
std::vector<int> NestedDissectionOrder(const Adjacency& adjacency);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_ELIMINATION_ORDER_H_
