// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/chordal_cost.h"

namespace gmapping_spa::backend {

LiftedPoses LiftPoses(const std::vector<SE2>& poses, int columns) {
  LiftedPoses lifted = LiftedPoses::Zero(RowOf(poses.size()), columns);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Eigen::Index row = RowOf(k);
    lifted(row, 0) = Complex(poses[k].x, poses[k].y);
    lifted(row + 1, 0) = std::polar(1.0, poses[k].theta);
  }
  return lifted;
}

ChordalCost::ChordalCost(const PoseGraphView& graph, const spa::GraphStructure& structure,
                         const std::vector<InformationSplit>& splits)
    : structure_(structure) {
  weights_.reserve(graph.edges.size());
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const SE2& i_T_j = graph.edges[k].i_T_j;
    weights_.push_back({splits[k].translation, splits[k].rotation, Complex(i_T_j.x, i_T_j.y),
                        std::polar(1.0, i_T_j.theta)});
  }
}

LiftedPoses ChordalCost::Gradient(const LiftedPoses& poses, bool free_only) const {
  const Eigen::Index columns = poses.cols();
  LiftedPoses gradient = LiftedPoses::Zero(poses.rows(), columns);
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const auto& [tau, w, measured, rotation] = weights_[k];
    const auto [i, j] = structure_.index().edges[k];
    if (i == j) continue;  // no pose changes it
    const Eigen::Index row_i = RowOf(i), row_j = RowOf(j);
    for (Eigen::Index c = 0; c < columns; ++c) {
      const Complex turned = poses(row_i + 1, c);
      const Complex translation = tau * (poses(row_j, c) - poses(row_i, c) - measured * turned);
      const Complex turn = w * (poses(row_j + 1, c) - rotation * turned);
      gradient(row_j, c) += translation;
      gradient(row_i, c) -= translation;
      gradient(row_j + 1, c) += turn;
      gradient(row_i + 1, c) -= std::conj(measured) * translation + std::conj(rotation) * turn;
    }
  }
  if (free_only) {
    for (std::size_t k = 0; k < structure_.index().fixed.size(); ++k) {
      if (structure_.index().fixed[k]) {
        gradient.middleRows(RowOf(k), 2).setZero();
      }
    }
  }
  return gradient;
}

LiftedMatrix ChordalCost::Matrix() const {
  const spa::BlockStructure& blocks = structure_.blocks();
  LiftedMatrix matrix;
  matrix.SetZero(blocks);
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const auto& [tau, w, measured, rotation] = weights_[k];
    const EdgeNodes nodes = structure_.index().edges[k];
    if (nodes.i == nodes.j) continue;
    EdgeBound bound;
    bound.tau = tau;
    bound.b = tau * measured;
    bound.h = -w * std::conj(rotation);
    AddEdge(blocks, k, nodes, bound, w + tau * std::norm(measured), w, &matrix);
  }
  return matrix;
}

}  // namespace gmapping_spa::backend
