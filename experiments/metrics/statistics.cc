#include "experiments/metrics/statistics.h"

#include <algorithm>
#include <cmath>
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

}  // namespace gmapping_spa::metrics
