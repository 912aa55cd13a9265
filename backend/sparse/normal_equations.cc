// SPDX-License-Identifier: BSD-3-Clause
#include "backend/sparse/normal_equations.h"

#include "backend/cost/edge_error.h"

namespace gmapping_spa::spa {
namespace {

using backend::Edge;
using backend::Heading;
using backend::SE2;

// Adds an edge with the error e = backend::EdgeError and the weight w of its loss. With R the
// rotation of node i and d the displacement t_j - t_i, both in the world frame, the Jacobians of
// backend::LinearizeEdge are
//   J_j = [R' 0; 0 1]   and   J_i = -J_j M,   M = [1 0 -d_y; 0 1 d_x; 0 0 1],
// so that all blocks follow from W = J_j' Lambda J_j with few operations:
//   H_jj = W,  H_ij = -M' W,  H_ii = M' W M,  g_j = J_j' Lambda e,  g_i = -M' g_j.
void AddEdge(const Edge& edge, const Eigen::Vector3d& information_error, double weight,
             const Heading& heading, double d_x, double d_y, int column_i, int column_j,
             BlockStructure::Slot slot, NormalEquations* equations) {
  const Eigen::Matrix3d& information = edge.information;
  const double c = heading.cos, s = heading.sin;
  const double a = weight * information(0, 0), b = weight * information(0, 1),
               e = weight * information(1, 1);
  const double p = c * a - s * b, q = c * b - s * e, r = s * a + c * b, t = s * b + c * e;
  Eigen::Matrix3d w;
  w(0, 0) = p * c - q * s;
  w(0, 1) = w(1, 0) = p * s + q * c;
  w(1, 1) = r * s + t * c;
  w(0, 2) = w(2, 0) = weight * (c * information(0, 2) - s * information(1, 2));
  w(1, 2) = w(2, 1) = weight * (s * information(0, 2) + c * information(1, 2));
  w(2, 2) = weight * information(2, 2);
  Eigen::Vector3d gradient_j(weight * (c * information_error.x() - s * information_error.y()),
                             weight * (s * information_error.x() + c * information_error.y()),
                             weight * information_error.z());

  if (column_j >= 0) {
    equations->hessian.diagonal(column_j) += w;
    equations->minus_gradient[column_j] -= gradient_j;
  }
  if (column_i >= 0) {
    // M' adds -d_y times the first row and d_x times the second one to the third.
    Eigen::Matrix3d mw = w;
    mw.row(2) += d_x * w.row(1) - d_y * w.row(0);
    equations->hessian.AddOffDiagonal(slot, -mw);
    mw.col(2) += d_x * mw.col(1) - d_y * mw.col(0);
    equations->hessian.diagonal(column_i) += mw;
    gradient_j.z() += d_x * gradient_j.y() - d_y * gradient_j.x();
    equations->minus_gradient[column_i] += gradient_j;
  }
}

// Edges come in another order than blocks lie in memory: the processor is told early which it
// needs.
void PrefetchBlocks(const backend::GraphIndex& index, const BlockStructure& structure,
                    std::size_t edge, const PoseMatrix& hessian) {
  constexpr std::size_t kAhead = 8;
  if (edge + kAhead >= index.edges.size()) return;
  const auto fetch = [](const double* block) {
    __builtin_prefetch(block, 1);
    __builtin_prefetch(block + 8, 1);
  };
  const auto [i, j] = index.edges[edge + kAhead];
  const int block = structure.slot_of_edge[edge + kAhead].block;
  const int a = structure.column_of_node[i], b = structure.column_of_node[j];
  if (block >= 0) fetch(hessian.off_diagonal(block).data());
  if (a >= 0) fetch(hessian.diagonal(a).data());
  if (b >= 0) fetch(hessian.diagonal(b).data());
}

void Begin(const BlockStructure& structure, const std::vector<SE2>& poses,
           NormalEquations* equations) {
  equations->headings.clear();
  for (const SE2& pose : poses) equations->headings.push_back(backend::HeadingOf(pose));
  equations->cost = 0.0;
  equations->hessian.SetZero(structure);
  equations->minus_gradient.assign(structure.columns(), PoseMatrix::Segment::Zero());
}

}  // namespace

void Linearize(const backend::PoseGraphView& graph, const backend::GraphIndex& index,
               const BlockStructure& structure, const std::vector<SE2>& poses,
               const backend::Loss& loss, NormalEquations* equations) {
  Begin(structure, poses, equations);
  const std::vector<Heading>& headings = equations->headings;
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const auto [i, j] = index.edges[k];
    PrefetchBlocks(index, structure, k, equations->hessian);
    const Eigen::Vector3d error = EdgeError(poses[i], headings[i], poses[j], edge.i_T_j);
    const Eigen::Vector3d information_error = edge.information * error;
    const backend::LossValue value =
        backend::EvaluateLoss(backend::LossOfEdge(edge, loss), error.dot(information_error));
    equations->cost += value.rho / 2.0;
    if (i == j) continue;  // no pose changes it
    AddEdge(edge, information_error, value.weight, headings[i], poses[j].x - poses[i].x,
            poses[j].y - poses[i].y, structure.column_of_node[i], structure.column_of_node[j],
            structure.slot_of_edge[k], equations);
  }
}

void LinearizeForTranslations(const backend::PoseGraphView& graph, const backend::GraphIndex& index,
                              const BlockStructure& structure, const std::vector<SE2>& poses,
                              NormalEquations* equations) {
  Begin(structure, poses, equations);
  const std::vector<Heading>& headings = equations->headings;
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const Edge& edge = graph.edges[k];
    const auto [i, j] = index.edges[k];
    if (i == j) continue;
    PrefetchBlocks(index, structure, k, equations->hessian);
    const Heading& heading = headings[i];
    const Eigen::Vector3d error = EdgeError(poses[i], heading, poses[j], edge.i_T_j);
    AddEdge(edge, edge.information * error, 1.0, heading,
            heading.cos * edge.i_T_j.x - heading.sin * edge.i_T_j.y,
            heading.sin * edge.i_T_j.x + heading.cos * edge.i_T_j.y, structure.column_of_node[i],
            structure.column_of_node[j], structure.slot_of_edge[k], equations);
  }
}

}  // namespace gmapping_spa::spa
