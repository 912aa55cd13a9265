// SPDX-License-Identifier: BSD-3-Clause
// What lifted poses prove about all poses.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_BOUND_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_BOUND_H_

#include "backend/certificate/chordal_cost.h"
#include "backend/certificate/lifted_solver.h"

namespace gmapping_spa::backend {

// A cost that no poses are below, in however many dimensions: the chordal cost of the lifted poses,
// minus what the gradient that is left and the smallest eigenvalue of their certificate matrix may
// hide. Near the chordal cost itself at its minimum in enough dimensions; from 0.
double LiftedBound(const spa::GraphStructure& structure, const ChordalCost& cost,
                   const LiftedPoses& poses, double margin, LiftedSolver* solver);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_LIFTED_BOUND_H_
