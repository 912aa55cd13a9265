// SPDX-License-Identifier: BSD-3-Clause
// Robust losses: what wrong loop closures may cost.
#ifndef GMAPPING_SPA_BACKEND_COST_ROBUST_LOSS_H_
#define GMAPPING_SPA_BACKEND_COST_ROBUST_LOSS_H_

#include <cstdint>
#include <limits>
#include <string>

namespace gmapping_spa::backend {

enum class LossKind : std::uint8_t { kNone, kHuber, kCauchy, kDcs, kTruncated, kMixture };

// A loss rho(s) of the squared error s = e' Omega e of an edge; its cost is rho(s) / 2.
struct Loss {
  LossKind kind = LossKind::kNone;
  // The error sqrt(s), in standard deviations, from which an edge counts as doubtful.
  double scale = 1.0;
  // Of kTruncated only: Yang et al. 2020's mu. Near 0 the loss is convex; infinity is the truncated
  // loss itself.
  double control = std::numeric_limits<double>::infinity();

  friend bool operator==(const Loss&, const Loss&) = default;
};

struct LossValue {
  double rho = 0.0;
  double weight = 1.0;  // d rho / d s: the weight of the edge in reweighted least squares
};

// With k = scale:
//   kNone       s
//   kHuber      s up to k^2, then 2 k sqrt(s) - k^2
//   kCauchy     k^2 log(1 + s / k^2)
//   kDcs        s up to k^2, then 4 k^2 s / (k^2 + s) - k^2: dynamic covariance scaling (Agarwal et
//               al. 2013, Phi = k^2), in the closed form of MacTavish and Barfoot 2015
//   kTruncated  min(s, k^2), or its surrogate for a finite control (Yang et al. 2020, eq. (7))
// Throws std::logic_error for kMixture, which is no function of one edge (see OptimizeRobustly).
LossValue EvaluateLoss(const Loss& loss, double s);

// Names as used on command lines: none, huber, cauchy, dcs, truncated,
// mixture. LossKindFromName throws
// std::runtime_error with one line that lists them.
const char* LossKindName(LossKind kind);
LossKind LossKindFromName(const std::string& name);

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_COST_ROBUST_LOSS_H_
