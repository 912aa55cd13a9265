// Calling an optimizer that may misbehave.
#ifndef GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_SAFELY_H_
#define GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_SAFELY_H_

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// Calls optimizer->Optimize and holds it to its contract: when it throws, reports failure, changes
// anything but poses, moves a fixed node, returns poses that are not finite or cost more than
// before, `graph` is as it was and the Summary a failure that says so. The costs of the Summary are
// GraphCost's, not the optimizer's. Throws like IndexGraph when the graph itself is malformed.
Summary OptimizeSafely(const Options& options, Optimizer* optimizer, PoseGraph* graph);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SCHEDULING_OPTIMIZE_SAFELY_H_
