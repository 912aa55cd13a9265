// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/sensor/max_range_filter.h"

namespace gmapping_spa::sensor {
namespace {

// What real readings do not do: a wall straight ahead, in whole centimeters, gives a few beams the
// same range, but hardly ever the longest one of the log, and not in one scan of ten.
constexpr std::int64_t kFewestInScan = 3;
constexpr std::int64_t kFewestScans = 20;
constexpr std::int64_t kScansPerScanWithSeveral = 10;
constexpr std::int64_t kReadingsPerLongest = 100;

}  // namespace

void MaxRangeFilter::Learn(const std::vector<const LaserScan*>& scans) {
  for (const LaserScan* scan : scans) {
    ++num_scans_;
    std::int64_t num_longest = 0;
    for (const Beam& beam : scan->beams) {
      if (beam.status == BeamStatus::kInvalid) continue;
      ++num_readings_;
      if (beam.status != BeamStatus::kHit || beam.range_m < longest_m_) continue;
      if (beam.range_m > longest_m_) {
        longest_m_ = beam.range_m;
        num_longest = num_longest_ = num_scans_with_several_ = 0;
      }
      ++num_longest;
    }
    num_longest_ += num_longest;
    if (num_longest >= kFewestInScan) ++num_scans_with_several_;
  }
}

bool MaxRangeFilter::LongestIsNoReturn() const {
  return num_scans_with_several_ >= kFewestScans &&
         num_scans_with_several_ * kScansPerScanWithSeveral >= num_scans_ &&
         num_longest_ * kReadingsPerLongest >= num_readings_;
}

std::int64_t MaxRangeFilter::Apply(LaserScan* scan) const {
  if (!LongestIsNoReturn()) return 0;
  std::int64_t num_changed = 0;
  for (Beam& beam : scan->beams) {
    if (beam.status != BeamStatus::kHit || beam.range_m != longest_m_) continue;
    beam.status = BeamStatus::kNoReturn;
    ++num_changed;
  }
  return num_changed;
}

}  // namespace gmapping_spa::sensor
