// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/loop_closure/place_descriptor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gmapping_spa::loop_closure {
namespace {

constexpr int kRings = 10;
constexpr int kSectors = 72;
constexpr int kFrequencies = 8;  // from 0 on; finer ones change with every step of the robot

// Column k: the cosine, then the sine of frequency k over the sectors.
Eigen::MatrixXf FourierBasis() {
  Eigen::MatrixXf basis(kSectors, 2 * kFrequencies);
  for (int sector = 0; sector < kSectors; ++sector) {
    for (int frequency = 0; frequency < kFrequencies; ++frequency) {
      const double phase = 2.0 * std::numbers::pi * frequency * sector / kSectors;
      basis(sector, frequency) = static_cast<float>(std::cos(phase));
      basis(sector, kFrequencies + frequency) = static_cast<float>(std::sin(phase));
    }
  }
  return basis;
}

}  // namespace

PlaceDescriptor ComputeDescriptor(const std::vector<Eigen::Vector2d>& points) {
  Eigen::MatrixXf counts = Eigen::MatrixXf::Zero(kRings, kSectors);
  for (const Eigen::Vector2d& point : points) {
    const double range_m = point.norm();
    if (range_m >= kDescriptorRadius_m) continue;
    const double turn = std::atan2(point.y(), point.x()) / (2.0 * std::numbers::pi) + 0.5;
    const int ring = static_cast<int>(range_m / kDescriptorRadius_m * kRings);
    counts(ring, static_cast<int>(turn * kSectors) % kSectors) += 1.0f;
  }
  static const Eigen::MatrixXf kBasis = FourierBasis();
  const Eigen::MatrixXf spectrum = counts.cwiseSqrt() * kBasis;
  const Eigen::MatrixXf magnitude = (spectrum.leftCols(kFrequencies).array().square() +
                                     spectrum.rightCols(kFrequencies).array().square())
                                        .sqrt();
  return magnitude.reshaped().stableNormalized();
}

double Dissimilarity(const PlaceDescriptor& a, const PlaceDescriptor& b) {
  return std::clamp(1.0 - static_cast<double>(a.dot(b)), 0.0, 1.0);
}

}  // namespace gmapping_spa::loop_closure
