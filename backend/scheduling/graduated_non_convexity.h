// SPDX-License-Identifier: BSD-3-Clause
// Graduated non-convexity on top of any optimizer.
#ifndef GMAPPING_SPA_BACKEND_SCHEDULING_GRADUATED_NON_CONVEXITY_H_
#define GMAPPING_SPA_BACKEND_SCHEDULING_GRADUATED_NON_CONVEXITY_H_

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// Minimises under the truncated loss options.loss (Yang, Antonante, Tzoumas, Carlone 2020,
// "Graduated Non-Convexity for Robust Spatial Perception"): a series of OptimizeSafely under
// surrogates that begin convex and end as the loss itself, each from the result of the one before.
// Wrong loop closures lose their say step by step, instead of keeping the first solution near
// themselves. The Summary has the iterations of the whole series; like OptimizeSafely, it ends no
// worse than it began. Throws std::invalid_argument when the loss is another one.
Summary OptimizeGradually(const Options& options, Optimizer* optimizer, PoseGraph* graph);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SCHEDULING_GRADUATED_NON_CONVEXITY_H_
