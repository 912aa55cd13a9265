// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/metrics/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace gmapping_spa::metrics {

Statistics ComputeStatistics(std::vector<double> errors) {
  if (errors.empty()) throw std::invalid_argument("statistics of nothing");
  std::sort(errors.begin(), errors.end());
  const std::size_t n = errors.size();
  double sum = 0.0, sum_of_squares = 0.0;
  for (const double error : errors) {
    sum += error;
    sum_of_squares += error * error;
  }
  const double mean = sum / n;
  // Deviations in a second pass: the difference of two large sums would lose a small spread.
  double sum_of_squared_deviations = 0.0;
  for (const double error : errors) sum_of_squared_deviations += (error - mean) * (error - mean);
  return {.rmse = std::sqrt(sum_of_squares / n),
          .mean = mean,
          .median = 0.5 * (errors[(n - 1) / 2] + errors[n / 2]),
          .std = std::sqrt(sum_of_squared_deviations / n),
          .min = errors.front(),
          .max = errors.back()};
}

std::optional<MeanAndP95> ComputeMeanAndP95(std::vector<double> errors) {
  if (errors.empty()) return std::nullopt;
  const std::size_t rank = (95 * errors.size() + 99) / 100;  // 95 % rounded up, from 1
  std::nth_element(errors.begin(), errors.begin() + (rank - 1), errors.end());
  const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
  return MeanAndP95{sum / errors.size(), errors[rank - 1]};
}

}  // namespace gmapping_spa::metrics
