// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/lifted_bound.h"

#include <algorithm>
#include <optional>

#include "backend/certificate/smallest_eigenvector.h"

namespace gmapping_spa::backend {

double LiftedBound(const spa::GraphStructure& structure, const ChordalCost& cost,
                   const LiftedPoses& poses, double margin, LiftedSolver* solver) {
  const std::vector<int>& nodes = structure.blocks().node_of_column;
  LiftedPoses gradient = cost.Gradient(poses, /*free_only=*/false);
  const double value = 0.5 * poses.conjugate().cwiseProduct(gradient).sum().real();
  LiftedMatrix matrix = cost.Matrix();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Eigen::Index row = RowOf(nodes[k]) + 1;
    const double multiplier = gradient.row(row).dot(poses.row(row)).real();
    matrix.diagonal(static_cast<int>(k)).diagonal().tail<2>().array() -= multiplier;
    gradient.row(row) -= multiplier * poses.row(row);
  }
  const std::optional<SmallestEigenvector> found =
      FindSmallestEigenvector(structure, matrix, margin, solver);
  if (!found) return 0.0;
  double decrease = 2.0 * found->shift * static_cast<double>(nodes.size());
  for (Eigen::Index c = 0; c < poses.cols(); ++c) {
    LiftedVector right(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Complex t = gradient(RowOf(nodes[k]), c), z = gradient(RowOf(nodes[k]) + 1, c);
      right[k] << t.real(), t.imag(), z.real(), z.imag();
    }
    LiftedVector x = right;
    solver->Solve(structure, &x);
    decrease += 0.5 * Dot(right, x);
  }
  return std::max(0.0, value - decrease);
}

}  // namespace gmapping_spa::backend
