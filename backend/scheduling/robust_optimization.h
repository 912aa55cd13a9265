// SPDX-License-Identifier: BSD-3-Clause
// Optimizing a graph some of whose loop closures are wrong, without anything to tune.
#ifndef GMAPPING_SPA_BACKEND_SCHEDULING_ROBUST_OPTIMIZATION_H_
#define GMAPPING_SPA_BACKEND_SCHEDULING_ROBUST_OPTIMIZATION_H_

#include "backend/plugin/optimizer.h"

namespace gmapping_spa::backend {

// What LossKind::kMixture stands for. Least squares, when neither the largest error of all loop
// closures nor the sum of all errors is larger than chance makes it; else the steps
//   1. dynamic covariance scaling, which finds poses near the truth,
//   2. a mixture of right and wrong closures is fitted to the errors there (FitClosureMixture),
//   3. least squares of those that are rather right than wrong, with the variance that they show,
// of which 2 and 3 are repeated until no closure changes sides. The loss that this minimizes is
// MixtureCost under the last mixture: the costs of the Summary. Its edge_weights are the inlier
// probabilities; its result costs no more than the given poses. Odometry and matches of consecutive
// scans are trusted.
//
// The optimizer must support LossKind::kDcs. Like OptimizeSafely, throws when the graph is
// malformed.
Summary OptimizeRobustly(const Options& options, Optimizer* optimizer, PoseGraph* graph);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_SCHEDULING_ROBUST_OPTIMIZATION_H_
