// SPDX-License-Identifier: BSD-3-Clause
#include "backend/cost/robust_loss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace gmapping_spa::backend {
namespace {

std::vector<Loss> SomeLosses() {
  std::vector<Loss> losses;
  for (const LossKind kind : {LossKind::kNone, LossKind::kHuber, LossKind::kCauchy, LossKind::kDcs,
                              LossKind::kTruncated}) {
    for (const double scale : {0.5, 1.0, 3.0}) losses.push_back({kind, scale});
  }
  for (const double control : {0.01, 1.0, 50.0}) {
    losses.push_back({LossKind::kTruncated, 2.0, control});
  }
  return losses;
}

TEST(EvaluateLoss, WeightIsTheDerivative) {
  for (const Loss& loss : SomeLosses()) {
    for (double s = 0.013; s < 100.0; s *= 1.31) {
      const double step = 1e-6 * s;
      const double slope =
          (EvaluateLoss(loss, s + step).rho - EvaluateLoss(loss, s - step).rho) / (2 * step);
      EXPECT_NEAR(EvaluateLoss(loss, s).weight, slope, 1e-6)
          << LossKindName(loss.kind) << " " << loss.scale << " " << loss.control << " at " << s;
    }
  }
}

TEST(EvaluateLoss, NeitherRhoNorTrustGrowsBeyondLeastSquares) {
  for (const Loss& loss : SomeLosses()) {
    double last_rho = 0.0, last_weight = 1.0;
    for (double s = 0.0; s < 100.0; s += 0.01) {
      const LossValue value = EvaluateLoss(loss, s);
      EXPECT_GE(value.rho, last_rho - 1e-12);
      EXPECT_LE(value.rho, s + 1e-12);
      EXPECT_LE(value.weight, last_weight + 1e-12);
      EXPECT_GE(value.weight, 0.0);
      last_rho = value.rho;
      last_weight = value.weight;
    }
  }
}

TEST(EvaluateLoss, HasTheValuesOfItsDefinition) {
  EXPECT_DOUBLE_EQ(EvaluateLoss({LossKind::kHuber, 2.0}, 9.0).rho, 2 * 2 * 3 - 4);
  EXPECT_DOUBLE_EQ(EvaluateLoss({LossKind::kCauchy, 2.0}, 12.0).rho, 4 * std::log(4.0));
  EXPECT_DOUBLE_EQ(EvaluateLoss({LossKind::kDcs, 1.0}, 3.0).weight, 0.25);  // (2 / (1 + 3))^2
  EXPECT_DOUBLE_EQ(EvaluateLoss({LossKind::kTruncated, 2.0}, 5.0).rho, 4.0);
  EXPECT_DOUBLE_EQ(EvaluateLoss({LossKind::kTruncated, 2.0}, 5.0).weight, 0.0);
}

TEST(EvaluateLoss, SurrogateOfTheTruncatedLossTendsToIt) {
  for (const double s : {0.5, 3.0, 4.5, 20.0}) {
    EXPECT_NEAR(EvaluateLoss({LossKind::kTruncated, 2.0, 1e6}, s).rho,
                EvaluateLoss({LossKind::kTruncated, 2.0}, s).rho, 1e-5);
  }
}

TEST(LossKindFromName, KnowsAllNamesAndNoOthers) {
  for (const Loss& loss : SomeLosses()) {
    EXPECT_EQ(LossKindFromName(LossKindName(loss.kind)), loss.kind);
  }
  EXPECT_THROW(LossKindFromName("hubert"), std::runtime_error);
}

}  // namespace
}  // namespace gmapping_spa::backend
