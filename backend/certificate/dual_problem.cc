// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/dual_problem.h"

#include <cmath>

namespace gmapping_spa::backend {
namespace {

// The matrix of a multiplication by a complex number.
Eigen::Matrix2d Multiplication(Complex a) {
  Eigen::Matrix2d matrix;
  matrix << a.real(), -a.imag(), a.imag(), a.real();
  return matrix;
}

}  // namespace

DualProblem MakeDualProblem(const PoseGraphView& graph, const spa::GraphStructure& structure,
                            const std::vector<InformationSplit>& splits,
                            const std::vector<SE2>& poses,
                            const std::vector<Eigen::Vector3d>& tangents) {
  const spa::BlockStructure& blocks = structure.blocks();
  DualProblem dual;
  dual.matrix.SetZero(blocks);
  dual.gradient.assign(blocks.columns(), LiftedMatrix::Segment::Zero());
  for (std::size_t k = 0; k < graph.edges.size(); ++k) {
    const auto [i, j] = structure.index().edges[k];
    const int column_i = blocks.column_of_node[i], column_j = blocks.column_of_node[j];
    if (column_i == column_j) continue;  // no pose changes it
    const EdgeBound bound =
        BoundEdge(graph.edges[k], splits[k], Between(poses[i], poses[j]), tangents[k]);
    dual.slack += bound.slack;
    AddEdge(blocks, k, {i, j}, bound, bound.stiffness_i, bound.stiffness_j, &dual.matrix);
    const Complex rotation_i = std::polar(1.0, poses[i].theta);
    const Complex rotation_j = std::polar(1.0, poses[j].theta);
    const Complex force = rotation_i * bound.force;
    if (column_i >= 0) {
      const Complex turn = Complex(0.0, bound.torque_i) * rotation_i;
      dual.gradient[column_i] +=
          Eigen::Vector4d(-force.real(), -force.imag(), turn.real(), turn.imag());
    }
    if (column_j >= 0) {
      const Complex turn = Complex(0.0, bound.torque_j) * rotation_j;
      dual.gradient[column_j] +=
          Eigen::Vector4d(force.real(), force.imag(), turn.real(), turn.imag());
    }
  }
  return dual;
}

void AddEdge(const spa::BlockStructure& structure, std::size_t edge, EdgeNodes nodes,
             const EdgeBound& bound, double stiffness_i, double stiffness_j, LiftedMatrix* matrix) {
  const int column_i = structure.column_of_node[nodes.i];
  const int column_j = structure.column_of_node[nodes.j];
  const Eigen::Matrix2d lever = Multiplication(bound.b);
  if (column_i >= 0) {
    auto diagonal = matrix->diagonal(column_i);
    diagonal.diagonal() += Eigen::Vector4d(bound.tau, bound.tau, stiffness_i, stiffness_i);
    diagonal.topRightCorner<2, 2>() += lever;
    diagonal.bottomLeftCorner<2, 2>() += lever.transpose();
  }
  if (column_j >= 0) {
    matrix->diagonal(column_j).diagonal() +=
        Eigen::Vector4d(bound.tau, bound.tau, stiffness_j, stiffness_j);
  }
  LiftedMatrix::Block cross;
  cross.topLeftCorner<2, 2>() = -bound.tau * Eigen::Matrix2d::Identity();
  cross.topRightCorner<2, 2>().setZero();
  cross.bottomLeftCorner<2, 2>() = -lever.transpose();
  cross.bottomRightCorner<2, 2>() = Multiplication(bound.h);
  matrix->AddOffDiagonal(structure.slot_of_edge[edge], cross);
}

LiftedVector Multiply(const spa::BlockStructure& structure, const LiftedMatrix& matrix,
                      const LiftedVector& x) {
  LiftedVector y(x.size());
  for (int k = 0; k < structure.columns(); ++k) {
    y[k] = matrix.diagonal(k) * x[k];
    for (int p = structure.begin[k]; p < structure.begin[k + 1]; ++p) {
      const int row = structure.row[p];
      y[row] += matrix.off_diagonal(p) * x[k];
      y[k] += matrix.off_diagonal(p).transpose() * x[row];
    }
  }
  return y;
}

double Dot(const LiftedVector& x, const LiftedVector& y) {
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += x[k].dot(y[k]);
  return sum;
}

}  // namespace gmapping_spa::backend
