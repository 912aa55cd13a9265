// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/normal_equations.h"

#include <Eigen/Geometry>
#include <cmath>

#include "backend/cost/edge_error.h"

namespace gmapping_spa::spa {
namespace {

using backend::Edge;
using backend::SE2;

// An edge at the poses of its nodes.
struct EdgeAtPoses {
  EdgeAtPoses(const SE2& world_T_i, const SE2& world_T_j, const SE2& i_T_j)
      : displacement(world_T_j.translation() - world_T_i.translation()) {
    const double c = std::cos(world_T_i.theta), s = std::sin(world_T_i.theta);
    rotation << c, -s, s, c;
    const Eigen::Vector2d i_t_j = rotation.transpose() * displacement;
    error = Minus({i_t_j.x(), i_t_j.y(), world_T_j.theta - world_T_i.theta}, i_T_j);
  }

  Eigen::Vector2d displacement;  // from node i to node j, in the world frame
  Eigen::Matrix2d rotation;      // of node i
  Eigen::Vector3d error;         // backend::EdgeError
};

// Adds an edge with the error e and the weight w of its loss. With R the rotation of node i and d
// the displacement t_j - t_i, both in the world frame, the Jacobians of backend::LinearizeEdge are
//   J_j = [R' 0; 0 1]   and   J_i = -J_j M,   M = [1 0 -d_y; 0 1 d_x; 0 0 1],
// so that all blocks follow from W = J_j' Lambda J_j with few operations:
//   H_jj = W,  H_ij = -M' W,  H_ii = M' W M,  g_j = J_j' Lambda e,  g_i = -M' g_j.
void AddEdge(const Edge& edge, const Eigen::Vector3d& weighted_error, double weight,
             const Eigen::Matrix2d& rotation, const Eigen::Vector2d& d, int column_i, int column_j,
             BlockStructure::Slot slot, NormalEquations* equations) {
  Eigen::Matrix3d w;
  w.topLeftCorner<2, 2>().noalias() =
      weight * rotation * edge.information.topLeftCorner<2, 2>() * rotation.transpose();
  w.topRightCorner<2, 1>().noalias() = weight * rotation * edge.information.topRightCorner<2, 1>();
  w.bottomLeftCorner<1, 2>() = w.topRightCorner<2, 1>().transpose();
  w(2, 2) = weight * edge.information(2, 2);
  Eigen::Vector3d gradient_j;
  gradient_j << weight * (rotation * weighted_error.head<2>()), weight * weighted_error.z();

  if (column_j >= 0) {
    equations->hessian.diagonal(column_j) += w;
    equations->minus_gradient[column_j] -= gradient_j;
  }
  if (column_i >= 0) {
    // M' adds -d_y times the first row and d_x times the second one to the third.
    Eigen::Matrix3d mw = w;
    mw.row(2) += d.x() * w.row(1) - d.y() * w.row(0);
    equations->hessian.AddOffDiagonal(slot, -mw);
    mw.col(2) += d.x() * mw.col(1) - d.y() * mw.col(0);
    equations->hessian.diagonal(column_i) += mw;
    gradient_j.z() += d.x() * gradient_j.y() - d.y() * gradient_j.x();
    equations->minus_gradient[column_i] += gradient_j;
  }
}

void SetZero(const BlockStructure& structure, NormalEquations* equations) {
  equations->cost = 0.0;
  equations->hessian.SetZero(structure);
  equations->minus_gradient.assign(structure.columns(), PoseMatrix::Segment::Zero());
}

}  // namespace

void Linearize(const backend::PoseGraphView& graph, const backend::GraphIndex& index,
               const BlockStructure& structure, const std::vector<SE2>& poses,
               const backend::Loss& loss, NormalEquations* equations) {
  SetZero(structure, equations);
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const auto [i, j] = index.edges[k];
    const EdgeAtPoses at(poses[i], poses[j], edge.i_T_j);
    const Eigen::Vector3d weighted_error = edge.information * at.error;
    const backend::LossValue value =
        backend::EvaluateLoss(backend::LossOfEdge(edge, loss), at.error.dot(weighted_error));
    equations->cost += value.rho / 2.0;
    if (i == j) continue;  // no pose changes it
    AddEdge(edge, weighted_error, value.weight, at.rotation, at.displacement,
            structure.column_of_node[i], structure.column_of_node[j], structure.slot_of_edge[k],
            equations);
  }
}

void LinearizeForTranslations(const backend::PoseGraphView& graph, const backend::GraphIndex& index,
                              const BlockStructure& structure, const std::vector<SE2>& poses,
                              NormalEquations* equations) {
  SetZero(structure, equations);
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const auto [i, j] = index.edges[k];
    if (i == j) continue;
    const EdgeAtPoses at(poses[i], poses[j], edge.i_T_j);
    AddEdge(edge, edge.information * at.error, 1.0, at.rotation,
            at.rotation * edge.i_T_j.translation(), structure.column_of_node[i],
            structure.column_of_node[j], structure.slot_of_edge[k], equations);
  }
}

}  // namespace gmapping_spa::spa
