// SPDX-License-Identifier: BSD-3-Clause
// Readings that are the laser's maximum range, where the log does not say that range.
#ifndef GMAPPING_SPA_FRONTEND_SENSOR_MAX_RANGE_FILTER_H_
#define GMAPPING_SPA_FRONTEND_SENSOR_MAX_RANGE_FILTER_H_

#include "frontend/sensor/beam_filter.h"

namespace gmapping_spa::sensor {

// A real longest reading of a log hardly occurs twice, bit for bit. Where one reading in a hundred
// is the longest one, it stands for "no return" (FLASER records cannot say their maximum range, and
// some ROBOTLASER1 records do not): such beams become kNoReturn. That is given up when a longer
// reading comes.
class MaxRangeFilter : public BeamFilter {
 public:
  void Learn(const std::vector<const LaserScan*>& scans) override;
  std::int64_t Apply(LaserScan* scan) const override;
  const char* count_name() const override { return "max_range_readings"; }

 private:
  bool LongestIsNoReturn() const;

  double longest_m_ = 0.0;
  std::int64_t num_longest_ = 0;             // readings of that length
  std::int64_t num_scans_with_several_ = 0;  // that have at least three of them
  std::int64_t num_readings_ = 0;            // of the log so far
  std::int64_t num_scans_ = 0;
};

}  // namespace gmapping_spa::sensor

#endif  // GMAPPING_SPA_FRONTEND_SENSOR_MAX_RANGE_FILTER_H_
