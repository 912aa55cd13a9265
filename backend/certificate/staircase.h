// SPDX-License-Identifier: BSD-3-Clause
// From a local minimum to the global one, with a certificate.
#ifndef GMAPPING_SPA_BACKEND_CERTIFICATE_STAIRCASE_H_
#define GMAPPING_SPA_BACKEND_CERTIFICATE_STAIRCASE_H_

#include <vector>

#include "backend/certificate/certifier.h"
#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// What was done to poses that were not proved to be optimal.
struct Descent {
  int rank = 0;       // dimensions of the lifted rotations; 0: the optimizer went on from the poses
  double cost = 0.0;  // of the poses that it led to
  bool accepted = false;  // they cost less than those before
};

struct StaircaseResult {
  Certificate certificate;  // of the poses that are returned
  double initial_cost = 0.0;
  double first_gap = 1.0;  // the relative gap of the poses that were given
  std::vector<Descent> descents;
};

struct StaircaseOptions {
  bool descend = true;  // else the poses are certified as they are
  int last_rank = 8;    // of the lifted rotations
};

// Certifies the poses of `graph` as the optimum of least squares. Where that fails, the optimizer
// goes on from them, in case that they are not yet at a minimum. Where the certificate matrix is
// not positive definite, the rotations get two dimensions more, the poses are moved along the
// direction of negative curvature into these, and go on to a minimum of the chordal cost there,
// where few local minima are left (the Riemannian staircase of Boumal 2015, as in SE-Sync); rounded
// to poses, they are where the optimizer starts again. What costs less is kept and certified, and
// left again where that fails; else there are two dimensions more, up to the last rank. Where all
// of that proves nothing, the lowest chordal cost of lifted poses still bounds the cost from below.
StaircaseResult ClimbStaircase(const StaircaseOptions& options, Optimizer* optimizer,
                               PoseGraph* graph);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_CERTIFICATE_STAIRCASE_H_
