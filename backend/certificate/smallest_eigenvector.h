// SPDX-License-Identifier: BSD-3-Clause
// The direction in which a certificate matrix is least positive.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_SMALLEST_EIGENVECTOR_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_SMALLEST_EIGENVECTOR_H_

#include <optional>

#include "backend/certificate/lifted_solver.h"

namespace gmapping_spa::backend {

struct SmallestEigenvector {
  LiftedVector vector;      // v' D v = 1, with D = diag(0, 0, 1, 1) for each node
  double eigenvalue = 0.0;  // v' S v: from above
  double shift = 0.0;       // S + shift D is positive definite
};

// Of S v = lambda D v, by inverse iteration: a shift that makes S positive definite is found by
// factorizations, and lowered to what the iterates say. Positions have no length in this metric:
// they are where S wants them, which the rotations decide. Nothing when no shift helps, which is so
// when the matrix is not finite or the positions are not determined. `solver` ends with the factor
// of that shift.
std::optional<SmallestEigenvector> FindSmallestEigenvector(const spa::GraphStructure& structure,
                                                           const LiftedMatrix& matrix,
                                                           double margin, LiftedSolver* solver);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_SMALLEST_EIGENVECTOR_H_
