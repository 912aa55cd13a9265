// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/robust_loss.h"

#include <cmath>
#include <stdexcept>

#include "backend/enum_names.h"

namespace gmapping_spa::backend {
namespace {

constexpr EnumName<LossKind> kNames[] = {
    {"none", LossKind::kNone},           {"huber", LossKind::kHuber},
    {"cauchy", LossKind::kCauchy},       {"dcs", LossKind::kDcs},
    {"truncated", LossKind::kTruncated}, {"mixture", LossKind::kMixture}};

LossValue EvaluateTruncated(double k2, double mu, double s) {
  if (std::isinf(mu)) return s <= k2 ? LossValue{s, 1.0} : LossValue{k2, 0.0};
  if (s <= mu / (mu + 1.0) * k2) return {s, 1.0};
  if (s >= (mu + 1.0) / mu * k2) return {k2, 0.0};
  const double root = std::sqrt(k2 * s * mu * (mu + 1.0));
  return {2.0 * root - mu * (k2 + s), root / s - mu};
}

}  // namespace

LossValue EvaluateLoss(const Loss& loss, double s) {
  const double k2 = loss.scale * loss.scale;
  switch (loss.kind) {
    case LossKind::kNone:
      break;
    case LossKind::kHuber: {
      if (s <= k2) break;
      const double root = std::sqrt(s);
      return {2.0 * loss.scale * root - k2, loss.scale / root};
    }
    case LossKind::kCauchy:
      return {k2 * std::log1p(s / k2), 1.0 / (1.0 + s / k2)};
    case LossKind::kDcs: {
      if (s <= k2) break;
      const double scaling = 2.0 * k2 / (k2 + s);
      return {2.0 * scaling * s - k2, scaling * scaling};
    }
    case LossKind::kTruncated:
      return EvaluateTruncated(k2, loss.control, s);
    case LossKind::kMixture:
      throw std::logic_error("the loss mixture is none of a single edge");
  }
  return {s, 1.0};
}

const char* LossKindName(LossKind kind) { return NameOf(kNames, kind); }

LossKind LossKindFromName(const std::string& name) { return FromName(kNames, name, "a loss"); }

}  // namespace gmapping_spa::backend
