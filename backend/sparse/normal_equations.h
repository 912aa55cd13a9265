// SPDX-License-Identifier: BSD-3-Clause
// The normal equations of a linearised pose graph.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_NORMAL_EQUATIONS_H_
#define GMAPPING_SPA_BACKEND_SPARSE_NORMAL_EQUATIONS_H_

#include <vector>

#include "backend/cost/edge_error.h"
#include "backend/cost/robust_loss.h"
#include "backend/graph/pose_graph.h"
#include "backend/sparse/block_matrix.h"

namespace gmapping_spa::spa {

// The cost at some poses and its expansion H dx = -g in the coordinates (x, y, theta) of the free
// nodes, in elimination order: H = J' Lambda J and g = J' Lambda e of the paper's eq. (5), the
// information Lambda of each edge weighted by its loss.
struct NormalEquations {
  double cost = 0.0;
  PoseMatrix hessian;
  PoseMatrix::Vector minus_gradient;
  std::vector<backend::Heading> headings;  // of all nodes: memory that is kept
};

// Linearises `graph` at `poses` (one for each node) straight into the blocks of `structure`.
void Linearize(const backend::PoseGraphView& graph, const backend::GraphIndex& index,
               const BlockStructure& structure, const std::vector<backend::SE2>& poses,
               const backend::Loss& loss, NormalEquations* equations);

// The same without a loss, for poses whose angles are good and whose free translations, zero, are
// not yet known: the derivatives by the angles are taken as if the translations already agreed with
// the measurements. What remains is linear in the translations.
void LinearizeForTranslations(const backend::PoseGraphView& graph, const backend::GraphIndex& index,
                              const BlockStructure& structure,
                              const std::vector<backend::SE2>& poses, NormalEquations* equations);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_NORMAL_EQUATIONS_H_
