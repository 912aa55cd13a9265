// SPDX-License-Identifier: BSD-3-Clause
// The linear system of a Levenberg-Marquardt step.
#ifndef GMAPPING_SPA_BACKEND_SPA_DAMPED_SOLVER_H_
#define GMAPPING_SPA_BACKEND_SPA_DAMPED_SOLVER_H_

#include <cstdint>

#include "backend/initialization/chordal_initialization.h"
#include "backend/sparse/cholmod_solver.h"
#include "backend/sparse/graph_structure.h"

namespace gmapping_spa::spa {

enum class LinearSolver : std::uint8_t { kBlock, kCholmod };

// Solves eq. (5) of Tao et al. 2021, (H + lambda diag(H)) dx = -g, and keeps its memory.
class DampedSolver {
 public:
  // False, with `*step` undefined, when the matrix is not positive definite. `*step` has a block
  // for each column of the structure.
  bool Solve(const GraphStructure& structure, double lambda, LinearSolver solver,
             SolverMemory* memory, PoseMatrix::Vector* step);

  // To be called when the structure is another one than in the last call.
  void ForgetStructure() { cholmod_knows_structure_ = false; }

 private:
  PoseMatrix damped_;
  CholmodSolver cholmod_;
  bool cholmod_knows_structure_ = false;
};

// By how much the step lowers the quadratic model of the cost: dx' (-g + lambda diag(H) dx) / 2.
double PredictedDecrease(const NormalEquations& equations, double lambda,
                         const PoseMatrix::Vector& step);

}  // namespace gmapping_spa::spa

#endif  // GMAPPING_SPA_BACKEND_SPA_DAMPED_SOLVER_H_
