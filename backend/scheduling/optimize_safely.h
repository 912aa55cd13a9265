// SPDX-License-Identifier: BSD-3-Clause
// Calling an optimizer that may misbehave.
#ifndef GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_SAFELY_H_
#define GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_SAFELY_H_

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// Sets the poses of options.initialization, calls optimizer->Optimize and holds it to its contract:
// when it throws, cannot do what the options ask for, reports failure, changes anything but poses,
// moves a fixed node, returns poses that are not finite or cost more than those it got, `graph` is
// as it was and the Summary a failure that says so. The costs of the Summary are GraphCost's, not
// the optimizer's. Where what came of the initialization costs more than the given poses, these are
// kept, and the message says so. Throws like IndexGraph when the graph itself is malformed.
Summary OptimizeSafely(const Options& options, Optimizer* optimizer, PoseGraph* graph);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_SAFELY_H_
