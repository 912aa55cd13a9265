// SPDX-License-Identifier: BSD-3-Clause
#include "backend/initialization/chordal_initialization.h"

#include <cmath>
#include <utility>

#include "backend/sparse/block_matrix.h"

namespace gmapping_spa::spa {
namespace {

using backend::Edge;
using backend::PoseGraphView;
using backend::SE2;

// Minimises sum w |r_j - R(theta_ij) r_i|^2 over the vectors r of the free nodes, where w is the
// information of the angle, and sets their angles to the directions of the vectors.
bool SolveRotations(const PoseGraphView& graph, const GraphStructure& graph_structure,
                    SolverMemory* memory, std::vector<SE2>* poses) {
  const BlockStructure& structure = graph_structure.blocks();
  using Matrix = BlockMatrix<2>;
  Matrix matrix(std::move(memory->equations.hessian));
  matrix.SetZero(structure);
  Matrix::Vector x(structure.columns(), Matrix::Segment::Zero());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const Edge& edge = graph.edges[e];
    const auto [i, j] = graph_structure.index().edges[e];
    const int a = structure.column_of_node[i], b = structure.column_of_node[j];
    if (a == b) continue;
    const double weight = edge.information(2, 2);
    const double c = weight * std::cos(edge.i_T_j.theta), s = weight * std::sin(edge.i_T_j.theta);
    Matrix::Block weighted_rotation;
    weighted_rotation << c, -s, s, c;
    if (a >= 0) matrix.diagonal(a).diagonal().array() += weight;
    if (b >= 0) matrix.diagonal(b).diagonal().array() += weight;
    matrix.AddOffDiagonal(structure.slot_of_edge[e], -weighted_rotation.transpose());
    const auto direction = [&](int node) {
      return Matrix::Segment(std::cos((*poses)[node].theta), std::sin((*poses)[node].theta));
    };
    if (a < 0) x[b] += weighted_rotation * direction(i);
    if (b < 0) x[a] += weighted_rotation.transpose() * direction(j);
  }
  const bool solved = memory->cholesky.Solve(graph_structure, matrix, &x);
  memory->equations.hessian = PoseMatrix(std::move(matrix));
  if (!solved) return false;
  for (int k = 0; k < structure.columns(); ++k) {
    (*poses)[structure.node_of_column[k]].theta = std::atan2(x[k].y(), x[k].x());
  }
  return true;
}

// Minimises sum w_r |r_j - R(theta_ij) r_i|^2 + w_t |t_j - t_i - [r_i] t_ij|^2 over the vectors r
// and the translations t of the free nodes, where [r] is the matrix with the columns r and r turned
// by 90 degrees: linear in both.
bool SolveRotationsAndTranslations(const PoseGraphView& graph,
                                   const GraphStructure& graph_structure, SolverMemory* memory,
                                   std::vector<SE2>* poses) {
  const BlockStructure& structure = graph_structure.blocks();
  using Matrix = BlockMatrix<4>;
  Matrix matrix(std::move(memory->equations.hessian));
  matrix.SetZero(structure);
  Matrix::Vector x(structure.columns(), Matrix::Segment::Zero());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const Edge& edge = graph.edges[e];
    const auto [i, j] = graph_structure.index().edges[e];
    const int a = structure.column_of_node[i], b = structure.column_of_node[j];
    if (a == b) continue;
    const double c = std::cos(edge.i_T_j.theta), s = std::sin(edge.i_T_j.theta);
    // The error is x_j - m x_i, with x = (r, t).
    Eigen::Matrix4d m;
    m << c, -s, 0, 0, s, c, 0, 0, edge.i_T_j.x, -edge.i_T_j.y, 1, 0, edge.i_T_j.y, edge.i_T_j.x, 0,
        1;
    const double w_t = (edge.information(0, 0) + edge.information(1, 1)) / 2.0;
    const Eigen::Vector4d w(edge.information(2, 2), edge.information(2, 2), w_t, w_t);
    const Eigen::Matrix4d weighted = m.transpose() * w.asDiagonal();
    const auto known = [&](int node) {
      const SE2& pose = (*poses)[node];
      return Eigen::Vector4d(std::cos(pose.theta), std::sin(pose.theta), pose.x, pose.y);
    };
    if (a >= 0) matrix.diagonal(a) += weighted * m;
    if (b >= 0) matrix.diagonal(b).diagonal() += w;
    matrix.AddOffDiagonal(structure.slot_of_edge[e], -weighted);
    if (a < 0) x[b] += w.cwiseProduct(m * known(i));
    if (b < 0) x[a] += weighted * known(j);
  }
  const bool solved = memory->cholesky.Solve(graph_structure, matrix, &x);
  memory->equations.hessian = PoseMatrix(std::move(matrix));
  if (!solved) return false;
  for (int k = 0; k < structure.columns(); ++k) {
    (*poses)[structure.node_of_column[k]] = {x[k][2], x[k][3], std::atan2(x[k][1], x[k][0])};
  }
  return true;
}

}  // namespace

bool InitializeFromRotations(const PoseGraphView& graph, const GraphStructure& structure,
                             SolverMemory* memory, std::vector<SE2>* poses) {
  const std::vector<int>& free_nodes = structure.blocks().node_of_column;
  for (const int node : free_nodes) (*poses)[node].x = (*poses)[node].y = 0.0;
  NormalEquations& equations = memory->equations;
  LinearizeForTranslations(graph, structure.index(), structure.blocks(), *poses, &equations);
  PoseMatrix::Vector& x = equations.minus_gradient;
  if (!memory->cholesky.Solve(structure, equations.hessian, &x)) {
    return false;
  }
  for (std::size_t k = 0; k < free_nodes.size(); ++k) {
    SE2& pose = (*poses)[free_nodes[k]];
    pose = {x[k].x(), x[k].y(), backend::WrapAngle(pose.theta + x[k].z())};
  }
  return true;
}

bool InitializeChordal(const PoseGraphView& graph, const GraphStructure& structure,
                       SolverMemory* memory, std::vector<SE2>* poses) {
  return SolveRotations(graph, structure, memory, poses) &&
         InitializeFromRotations(graph, structure, memory, poses);
}

bool InitializeChordalJointly(const PoseGraphView& graph, const GraphStructure& structure,
                              SolverMemory* memory, std::vector<SE2>* poses) {
  return SolveRotationsAndTranslations(graph, structure, memory, poses) &&
         InitializeFromRotations(graph, structure, memory, poses);
}

}  // namespace gmapping_spa::spa
