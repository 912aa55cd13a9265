// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/certifier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "backend/certificate/smallest_eigenvector.h"
#include "backend/cost/edge_error.h"
#include "backend/cost/graph_cost.h"

namespace gmapping_spa::backend {
namespace {

// Part of the gap that may be spent on a shift.
constexpr double kShiftPart = 0.5;

// x' diag(matrix)^-1 x.
double NormInInverseDiagonal(const LiftedMatrix& matrix, const LiftedVector& x) {
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sum += (x[k].array().square() / matrix.diagonal(static_cast<int>(k)).diagonal().array()).sum();
  }
  return sum;
}

}  // namespace

bool Certificate::optimal() const {
  return relative_gap <= kOptimalGap || cost - lower_bound <= kOptimalCost;
}

Certifier::Certifier(const PoseGraphView& graph) : graph_(graph) {
  structure_.Update(IndexGraph(graph));
  splits_.reserve(graph.edges.size());
  for (const Edge& edge : graph.edges) splits_.push_back(SplitInformation(edge.information));
}

std::vector<Eigen::Vector3d> Certifier::Tangents(const std::vector<SE2>& poses) {
  const spa::BlockStructure& blocks = structure_.blocks();
  Linearize(graph_, structure_.index(), blocks, poses, {}, &equations_);
  spa::PoseMatrix::Vector step = equations_.minus_gradient;
  if (!cholesky_.Solve(structure_, equations_.hessian, &step)) {
    step.assign(blocks.columns(), spa::PoseMatrix::Segment::Zero());
  }
  const auto step_of = [&](int node) -> Eigen::Vector3d {
    const int column = blocks.column_of_node[node];
    return column < 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(step[column]);
  };
  std::vector<Eigen::Vector3d> tangents(graph_.edges.size());
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    const auto [i, j] = structure_.index().edges[k];
    const LinearizedEdge edge = LinearizeEdge(poses[i], poses[j], graph_.edges[k].i_T_j);
    tangents[k] = edge.error + edge.jacobian_i * step_of(i) + edge.jacobian_j * step_of(j);
    if (!(std::abs(tangents[k].z()) < std::numbers::pi)) tangents[k] = edge.error;
  }
  return tangents;
}

bool Certifier::TryShift(double shift, Certificate* certificate) {
  LiftedVector x = dual_.gradient;
  if (!solver_.FactorizeAndSolve(structure_, dual_.matrix, shift, certificate->margin, &x)) {
    return false;
  }
  // The minimum of gradient' w + 1/2 w' (S + shift) w is at -x, but for the error of x, which is
  // bounded by the part of the diagonal that the matrix has to spare.
  LiftedVector rest = Multiply(structure_.blocks(), dual_.matrix, x);
  for (std::size_t k = 0; k < rest.size(); ++k) rest[k].tail<2>() += shift * x[k].tail<2>();
  const double decrease = Dot(dual_.gradient, x) - 0.5 * Dot(x, rest);
  for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = dual_.gradient[k] - rest[k];
  const double error = 0.5 * NormInInverseDiagonal(dual_.matrix, rest) / certificate->margin;
  const double shifted = 2.0 * shift * structure_.blocks().columns();
  const double gap = dual_.slack + std::max(0.0, decrease) + error + shifted;
  certificate->positive_definite = shift == 0.0;
  certificate->shift = shift;
  certificate->lower_bound = std::max(0.0, certificate->cost - gap);
  certificate->relative_gap =
      certificate->cost > 0.0 ? std::min(1.0, gap / certificate->cost) : 0.0;
  return true;
}

Certificate Certifier::Certify(const std::vector<SE2>& poses) {
  Certificate certificate;
  certificate.cost = GraphCost(graph_, structure_.index(), poses);
  const int unknowns = LiftedMatrix::kSize * structure_.blocks().columns();
  certificate.margin = std::numeric_limits<double>::epsilon() * std::max(unknowns, 1000);
  if (unknowns == 0) {
    certificate.lower_bound = certificate.cost;
    certificate.relative_gap = 0.0;
    certificate.positive_definite = true;
    return certificate;
  }
  dual_ = MakeDualProblem(graph_, structure_, splits_, poses, Tangents(poses));
  if (TryShift(0.0, &certificate)) return certificate;
  const double shift = kShiftPart * std::max(kOptimalGap * certificate.cost, kOptimalCost) /
                       (2.0 * structure_.blocks().columns());
  TryShift(shift, &certificate);
  return certificate;
}

std::optional<LiftedVector> Certifier::NegativeCurvature(Certificate* certificate) {
  const std::optional<SmallestEigenvector> found =
      FindSmallestEigenvector(structure_, dual_.matrix, certificate->margin, &solver_);
  if (!found) return std::nullopt;
  certificate->smallest_eigenvalue = found->eigenvalue;
  if (certificate->relative_gap == 1.0) TryShift(found->shift, certificate);
  if (!(found->eigenvalue < 0.0)) return std::nullopt;
  return found->vector;
}

}  // namespace gmapping_spa::backend
