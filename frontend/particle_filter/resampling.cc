// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/particle_filter/resampling.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gmapping_spa::particle_filter {

std::vector<double> NormalizedWeights(const std::vector<double>& log_weights, double gain) {
  CHECK(!log_weights.empty());
  const double largest = *std::max_element(log_weights.begin(), log_weights.end());
  std::vector<double> weights;
  weights.reserve(log_weights.size());
  for (const double log_weight : log_weights) {
    weights.push_back(std::exp(gain * (log_weight - largest)));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

double EffectiveSampleSize(const std::vector<double>& weights) {
  return 1.0 / std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

std::vector<int> SystematicResample(const std::vector<double>& weights, int count, double uniform) {
  const int size = static_cast<int>(weights.size());
  std::vector<int> ancestors;
  double cumulative = 0.0;
  for (int i = 0; i < size; ++i) {
    cumulative += weights[i] * count;
    while (static_cast<int>(ancestors.size()) < count &&
           static_cast<double>(ancestors.size()) + uniform < cumulative) {
      ancestors.push_back(i);
    }
  }
  // Rounding may leave the sum of the weights a hair below 1.
  ancestors.resize(count, size - 1);
  return ancestors;
}

}  // namespace gmapping_spa::particle_filter
