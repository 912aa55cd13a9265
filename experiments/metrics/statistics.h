// SPDX-License-Identifier: BSD-3-Clause
// What is reported of a set of errors.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_STATISTICS_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_STATISTICS_H_

#include <optional>
#include <vector>

namespace gmapping_spa::metrics {

// In the unit of the errors. The standard deviation is that of the population (divided by n), as in
// the published results; the median of an even number of errors is the mean of the middle two.
struct Statistics {
  double rmse = 0.0;
  double mean = 0.0;
  double median = 0.0;
  double std = 0.0;
  double min = 0.0;
  double max = 0.0;
};

// Throws std::invalid_argument when there are no errors.
Statistics ComputeStatistics(std::vector<double> errors);

struct MeanAndP95 {
  double mean = 0.0;
  double p95 = 0.0;  // the smallest error that 95 % of the errors do not exceed
};

// Nothing when there are no errors.
std::optional<MeanAndP95> ComputeMeanAndP95(std::vector<double> errors);

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_STATISTICS_H_
