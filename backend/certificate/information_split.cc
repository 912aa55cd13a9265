// SPDX-License-Identifier: BSD-3-Clause
#include "backend/certificate/information_split.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gmapping_spa::backend {
namespace {

// Eigenvalues may be off by this part of the largest one.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();

}  // namespace

InformationSplit SplitInformation(const Eigen::Matrix3d& information) {
  const double mean = (information(0, 0) + information(1, 1)) / 2.0;
  const double radius =
      std::hypot((information(0, 0) - information(1, 1)) / 2.0, information(0, 1));
  const double translation = std::max(0.0, mean - radius - kRounding * (mean + radius));
  const double rotation = std::max(0.0, information(2, 2));
  if (information(0, 2) == 0.0 && information(1, 2) == 0.0) return {translation, rotation};
  if (translation == 0.0 || rotation == 0.0) return {};
  const Eigen::Vector3d scale =
      Eigen::Vector3d(translation, translation, rotation).cwiseSqrt().cwiseInverse();
  const Eigen::Matrix3d scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scaled, Eigen::EigenvaluesOnly);
  const double part = std::max(0.0, solver.eigenvalues()(0) - kRounding * solver.eigenvalues()(2));
  return {part * translation, part * rotation};
}

}  // namespace gmapping_spa::backend
