// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/lifted_descent.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "backend/initialization/chordal_initialization.h"

namespace gmapping_spa::backend {
namespace {

constexpr double kMargin = 1e-10;  // see LiftedSolver
constexpr int kMaxProductsOfStep = 60;
constexpr double kResidualRatio = 1e-2;  // of the preconditioned residual, squared
constexpr double kLeastGain = 0.1;       // of the promised decrease, for a step to be taken

double Product(const LiftedPoses& a, const LiftedPoses& b) {
  return a.conjugate().cwiseProduct(b).sum().real();
}

// Takes away what would change the length of rotations.
void Project(const LiftedPoses& poses, LiftedPoses* direction) {
  for (Eigen::Index row = 1; row < poses.rows(); row += 2) {
    const double along = direction->row(row).dot(poses.row(row)).real();
    direction->row(row) -= along * poses.row(row);
  }
}

LiftedPoses Moved(const LiftedPoses& poses, const LiftedPoses& step) {
  LiftedPoses moved = poses + step;
  for (Eigen::Index row = 1; row < poses.rows(); row += 2) moved.row(row).normalize();
  return moved;
}

}  // namespace

LiftedPoses LiftedDescent::Precondition(const LiftedPoses& poses,
                                        const LiftedPoses& gradient) const {
  const std::vector<int>& nodes = structure_.blocks().node_of_column;
  LiftedPoses result = LiftedPoses::Zero(gradient.rows(), gradient.cols());
  LiftedVector x(nodes.size());
  for (Eigen::Index c = 0; c < gradient.cols(); ++c) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Complex t = gradient(RowOf(nodes[k]), c), z = gradient(RowOf(nodes[k]) + 1, c);
      x[k] << t.real(), t.imag(), z.real(), z.imag();
    }
    solver_.Solve(structure_, &x);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      result(RowOf(nodes[k]), c) = Complex(x[k][0], x[k][1]);
      result(RowOf(nodes[k]) + 1, c) = Complex(x[k][2], x[k][3]);
    }
  }
  Project(poses, &result);
  return result;
}

// Steihaug's conjugate gradients: lengths are measured by the preconditioner.
LiftedDescent::Step LiftedDescent::FindStep(const LiftedPoses& poses, const LiftedPoses& gradient,
                                            double radius, int* products) const {
  Eigen::VectorXd multiplier(poses.rows());
  for (Eigen::Index row = 0; row < poses.rows(); ++row) {
    multiplier[row] = row % 2 == 0 ? 0.0 : gradient.row(row).dot(poses.row(row)).real();
  }
  LiftedPoses residual = gradient;
  Project(poses, &residual);
  LiftedPoses preconditioned = Precondition(poses, residual);
  LiftedPoses direction = -preconditioned;
  Step found{LiftedPoses::Zero(poses.rows(), poses.cols()), 0.0, 0.0, false};
  double product = Product(residual, preconditioned);
  const double first = product;
  double step_square = 0.0, step_direction = 0.0, direction_square = product;
  for (int k = 0; k < kMaxProductsOfStep && product > 0.0; ++k, ++*products) {
    LiftedPoses curved = cost_.Gradient(direction, /*free_only=*/true);
    curved -= multiplier.asDiagonal() * direction;
    Project(poses, &curved);
    const double curvature = Product(direction, curved);
    const double length = product / curvature;
    const double next_square =
        step_square + 2.0 * length * step_direction + length * length * direction_square;
    found.at_border = !(curvature > 0.0) || next_square >= radius * radius;
    const double taken =
        found.at_border
            ? (-step_direction + std::sqrt(step_direction * step_direction +
                                           direction_square * (radius * radius - step_square))) /
                  direction_square
            : length;
    // The residual is orthogonal to the earlier steps: what this one promises.
    found.predicted += taken * product - 0.5 * taken * taken * curvature;
    found.step += taken * direction;
    step_square += 2.0 * taken * step_direction + taken * taken * direction_square;
    if (found.at_border) break;
    residual += length * curved;
    preconditioned = Precondition(poses, residual);
    const double next_product = Product(residual, preconditioned);
    if (!(next_product > kResidualRatio * first)) break;
    const double ratio = next_product / product;
    step_direction = ratio * (step_direction + length * direction_square);
    direction_square = next_product + ratio * ratio * direction_square;
    product = next_product;
    direction = ratio * direction - preconditioned;
  }
  found.norm = std::sqrt(step_square);
  return found;
}

double LiftedDescent::Minimize(const Options& options, LiftedPoses* poses) {
  LiftedPoses gradient = cost_.Gradient(*poses, /*free_only=*/false);
  double cost = 0.5 * Product(*poses, gradient);
  LiftedVector unused(structure_.blocks().columns(), LiftedMatrix::Segment::Zero());
  if (!solver_.FactorizeAndSolve(structure_, cost_.Matrix(), 0.0, -kMargin, &unused)) return cost;
  double radius = std::sqrt(2.0 * cost);
  int products = 0;
  while (products < options.max_products && cost > 0.0) {
    for (std::size_t k = 0; k < structure_.index().fixed.size(); ++k) {
      if (structure_.index().fixed[k]) {
        gradient.middleRows(RowOf(k), 2).setZero();
      }
    }
    const Step step = FindStep(*poses, gradient, radius, &products);
    ++products;
    if (!(step.predicted > 0.0)) break;
    LiftedPoses next = Moved(*poses, step.step);
    LiftedPoses next_gradient = cost_.Gradient(next, /*free_only=*/false);
    const double next_cost = 0.5 * Product(next, next_gradient);
    const double gain = (cost - next_cost) / step.predicted;
    if (gain < 0.25) {
      radius = 0.25 * step.norm;
    } else if (gain > 0.75 && step.at_border) {
      radius *= 2.0;
    }
    if (!(gain > kLeastGain)) {
      if (step.predicted < options.cost_tolerance * cost) break;
      continue;
    }
    const bool last = !step.at_border && cost - next_cost < options.cost_tolerance * cost;
    cost = next_cost;
    *poses = std::move(next);
    gradient = std::move(next_gradient);
    if (last) break;
  }
  return cost;
}

bool RoundPoses(const PoseGraphView& graph, const spa::GraphStructure& structure,
                const LiftedPoses& lifted, std::vector<SE2>* poses) {
  Eigen::MatrixXcd gram = Eigen::MatrixXcd::Zero(lifted.cols(), lifted.cols());
  for (Eigen::Index row = 1; row < lifted.rows(); row += 2) {
    gram += lifted.row(row).adjoint() * lifted.row(row);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(gram);
  Eigen::VectorXcd shared = solver.eigenvectors().col(lifted.cols() - 1);
  // Held nodes are as before in the first column.
  if (std::abs(shared[0]) > 0.0) shared *= std::conj(shared[0]) / std::abs(shared[0]);
  for (const int node : structure.blocks().node_of_column) {
    (*poses)[node].theta = std::arg((lifted.row(RowOf(node) + 1) * shared).value());
  }
  spa::SolverMemory memory;
  return InitializeFromRotations(graph, structure, &memory, poses);
}

}  // namespace gmapping_spa::backend
