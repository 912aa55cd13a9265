// SPDX-License-Identifier: BSD-3-Clause
// Covariances of what an optimization came to, with any back end.
#ifndef GMAPPING_SPA_BACKEND_SCHEDULING_COVARIANCES_H_
#define GMAPPING_SPA_BACKEND_SCHEDULING_COVARIANCES_H_

#include <span>
#include <vector>

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// The edges whose least squares the result of Optimize is the minimum of: those that `loss` leaves,
// their information times the weight that `summary` has for each; under LossKind::kMixture the
// accepted ones, loop closures with the variance that they show.
std::vector<Edge> EdgesOfResult(const Loss& loss, std::span<const Edge> edges,
                                const Summary& summary);

// Optimizer::Covariances of the optimizer if it has them, else by the sparse factor of the graph
// (sparse/graph_covariance.h). Throws std::runtime_error with one line when the edges do not
// determine all poses, or what the optimizer returns can be no covariances. Throws like IndexGraph
// when the graph is malformed.
std::vector<Eigen::Matrix3d> Covariances(const PoseGraphView& graph,
                                         std::span<const EdgeNodes> pairs, Optimizer* optimizer);

// The covariance of the relative pose i_T_j, x and y along the axes of frame i (the frame of an
// edge's information), to first order: from those of the two poses and the one between them (i
// rows, j columns) as Covariances has them.
Eigen::Matrix3d RelativeCovariance(const SE2& world_T_i, const SE2& world_T_j,
                                   const Eigen::Matrix3d& covariance_i,
                                   const Eigen::Matrix3d& covariance_ij,
                                   const Eigen::Matrix3d& covariance_j);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SCHEDULING_COVARIANCES_H_
