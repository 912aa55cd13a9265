// SPDX-License-Identifier: BSD-3-Clause
// Covariances of the poses of a graph.
#ifndef GMAPPING_SPA_BACKEND_SPARSE_GRAPH_COVARIANCE_H_
#define GMAPPING_SPA_BACKEND_SPARSE_GRAPH_COVARIANCE_H_

#include <optional>
#include <span>
#include <vector>

#include "backend/graph/graph_index.h"
#include "backend/graph/pose_graph.h"
#include "backend/sparse/block_cholesky.h"
#include "backend/sparse/graph_structure.h"
#include "backend/sparse/normal_equations.h"

namespace gmapping_spa::spa {

// For each pair of nodes (positions), the covariance between the pose (x, y, theta) of i, rows, and
// that of j, columns, in m and rad: that of least squares, all edges at their information, as it is
// to first order at the poses of `graph`. Errors are added to coordinates (backend::Plus), so that
// those of x and y are along the axes of the world frame. They are relative to the held nodes,
// which have none: a node's covariance says how well it is known from the held ones of its
// component. Components know nothing of each other.
//
// Nothing where the covariances do not exist: the edges do not determine all poses. `structure` is
// that of the graph; `equations` and `cholesky` lend their memory.
std::optional<std::vector<Eigen::Matrix3d>> CovariancesOf(const backend::PoseGraphView& graph,
                                                          std::span<const backend::EdgeNodes> pairs,
                                                          const GraphStructure& structure,
                                                          NormalEquations* equations,
                                                          BlockCholesky* cholesky);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPARSE_GRAPH_COVARIANCE_H_
