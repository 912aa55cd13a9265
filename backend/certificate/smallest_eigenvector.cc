// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/smallest_eigenvector.h"

#include <algorithm>
#include <cmath>

#include "backend/counter_random.h"

namespace gmapping_spa::backend {
namespace {

constexpr int kLargestRaises = 40;
constexpr double kRaise = 30.0;
constexpr int kRounds = 10;          // of lowering the shift
constexpr int kIterations = 6;       // of a round
constexpr double kNearEnough = 1.5;  // times the eigenvalue that a shift may be

// Scales to v' D v = 1, and makes D v of v.
void Normalize(LiftedVector* v) {
  double sum = 0.0;
  for (const LiftedMatrix::Segment& segment : *v) sum += segment.tail<2>().squaredNorm();
  const double scale = 1.0 / std::sqrt(sum);
  for (LiftedMatrix::Segment& segment : *v) segment *= scale;
}

LiftedVector InMetric(const LiftedVector& v) {
  LiftedVector dv = v;
  for (LiftedMatrix::Segment& segment : dv) segment.head<2>().setZero();
  return dv;
}

double LargestDiagonal(const LiftedMatrix& matrix, int columns) {
  double largest = 0.0;
  for (int k = 0; k < columns; ++k) {
    largest = std::max(largest, matrix.diagonal(k).diagonal().tail<2>().cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

std::optional<SmallestEigenvector> FindSmallestEigenvector(const spa::GraphStructure& structure,
                                                           const LiftedMatrix& matrix,
                                                           double margin, LiftedSolver* solver) {
  const spa::BlockStructure& blocks = structure.blocks();
  CounterRandom random(/*seed=*/1, /*stream=*/0);
  LiftedVector start(blocks.columns());
  for (LiftedMatrix::Segment& segment : start) {
    segment << 0.0, 0.0, random.Gaussian(), random.Gaussian();
  }
  const double largest = LargestDiagonal(matrix, blocks.columns());
  if (!std::isfinite(largest)) return std::nullopt;
  SmallestEigenvector found;
  found.shift = 1e-8 * largest;
  found.vector = start;
  int raises = 0;
  while (!solver->FactorizeAndSolve(structure, matrix, found.shift, margin, &found.vector)) {
    if (++raises > kLargestRaises) return std::nullopt;
    found.shift *= kRaise;
    found.vector = start;
  }
  double failed_shift = raises > 0 ? found.shift / kRaise : 0.0;
  for (int round = 0; round < kRounds; ++round) {
    for (int k = 0; k < kIterations; ++k) {
      found.vector = InMetric(found.vector);
      solver->Solve(structure, &found.vector);
      Normalize(&found.vector);
    }
    found.eigenvalue = Dot(found.vector, Multiply(blocks, matrix, found.vector));
    // The eigenvalue is at most that of the iterate: a shift below it fails, one a little above it
    // need not do.
    const double least = std::max(failed_shift, -found.eigenvalue);
    if (least <= 0.0 || found.shift <= kNearEnough * least) break;
    const double shift = std::min(std::sqrt(least * found.shift), 1.2 * least);
    LiftedVector next = InMetric(found.vector);
    if (solver->FactorizeAndSolve(structure, matrix, shift, margin, &next)) {
      found.shift = shift;
      found.vector = std::move(next);
    } else {
      failed_shift = shift;
      next = InMetric(found.vector);
      solver->FactorizeAndSolve(structure, matrix, found.shift, margin, &next);
    }
  }
  return found;
}

}  // namespace gmapping_spa::backend
