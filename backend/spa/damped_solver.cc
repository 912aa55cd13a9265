// SPDX-License-Identifier: BSD-3-Clause
#include "backend/spa/damped_solver.h"

#include <utility>

namespace gmapping_spa::spa {

bool DampedSolver::Solve(const GraphStructure& structure, double lambda, LinearSolver solver,
                         SolverMemory* memory, PoseMatrix::Vector* step) {
  const PoseMatrix* hessian = &memory->equations.hessian;
  if (lambda > 0.0) {
    damped_ = *hessian;
    for (int k = 0; k < structure.blocks().columns(); ++k) {
      Eigen::Map<PoseMatrix::Block> block = damped_.diagonal(k);
      // Coordinates that no measurement sees are held by the damping alone.
      for (int c = 0; c < PoseMatrix::kSize; ++c)
        block(c, c) += lambda * (block(c, c) > 0.0 ? block(c, c) : 1.0);
    }
    hessian = &damped_;
  }
  *step = memory->equations.minus_gradient;
  if (solver == LinearSolver::kCholmod) {
    return cholmod_.Solve(structure.blocks(), *hessian,
                          !std::exchange(cholmod_knows_structure_, true), step);
  }
  return memory->cholesky.Solve(structure, *hessian, step);
}

double PredictedDecrease(const NormalEquations& equations, double lambda,
                         const PoseMatrix::Vector& step) {
  double decrease = 0.0;
  for (std::size_t k = 0; k < step.size(); ++k) {
    const PoseMatrix::Segment damped =
        lambda * equations.hessian.diagonal(static_cast<int>(k)).diagonal().cwiseProduct(step[k]);
    decrease += 0.5 * step[k].dot(equations.minus_gradient[k] + damped);
  }
  return decrease;
}

}  // namespace gmapping_spa::spa
