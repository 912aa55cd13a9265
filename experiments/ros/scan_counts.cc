// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/scan_counts.h"

namespace gmapping_spa::ros {

bool IsComplete(const ScanCounts& counts) {
  return counts.lost + counts.refused + counts.after_time_jump + counts.transforms_refused == 0;
}

std::vector<std::pair<std::string, std::int64_t>> NamedCounts(const ScanCounts& counts) {
  return {{"lost", counts.lost},
          {"received", counts.received},
          {"throttled", counts.throttled},
          {"refused", counts.refused},
          {"after_time_jump", counts.after_time_jump},
          {"waiting", counts.waiting},
          {"used", counts.used},
          {"transforms_refused", counts.transforms_refused}};
}

}  // namespace gmapping_spa::ros
