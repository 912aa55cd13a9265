// SPDX-License-Identifier: BSD-3-Clause
// Certifying what an optimization under any loss came to.
#ifndef GMAPPING_SPA_BACKEND_SCHEDULING_CERTIFY_RESULT_H_
#define GMAPPING_SPA_BACKEND_SCHEDULING_CERTIFY_RESULT_H_

#include <string>

#include "backend/certificate/staircase.h"

namespace gmapping_spa::backend {

struct CertifiedResult {
  std::string problem;  // one phrase: which least squares problem the certificate is about
  StaircaseResult staircase;
  std::string message;  // one line: what is proved, and what became of the poses

  bool proved() const { return staircase.certificate.optimal(); }
};

// Certifies the poses of `graph` that backend::Optimize left with `summary`. What is certified is
//   without a loss        the least squares of all edges,
//   LossKind::kMixture    the least squares of the edges that were not rejected, the information of
//                         loop closures divided by the variance factor: that no other poses explain
//                         these edges better, not that these are the right ones,
//   any other loss        the least squares with the weights that the loss gives the edges at the
//                         poses: nothing about the loss itself, whose cost other poses may lower.
// With `descend`, better poses replace those of the graph, by ClimbStaircase with `optimizer`, and
// the final cost in `*summary`; not under the losses of the third kind, whose weights would be
// others then, and under kMixture only where MixtureCost is lower as well.
CertifiedResult CertifyResult(const Loss& loss, bool descend, Optimizer* optimizer,
                              PoseGraph* graph, Summary* summary);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SCHEDULING_CERTIFY_RESULT_H_
