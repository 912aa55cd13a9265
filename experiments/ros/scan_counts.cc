// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/ros/scan_counts.h"

namespace gmapping_spa::ros {
namespace {

constexpr double kLongSilence_s = 10.0;
constexpr std::int64_t kManyWait = 50;  // five seconds of most lidars

}  // namespace

bool IsComplete(const ScanCounts& counts) {
  return counts.lost + counts.refused + counts.after_time_jump + counts.transforms_refused == 0;
}

std::string ProblemOf(const ScanCounts& counts) {
  if (counts.silent_s > kLongSilence_s) {
    return counts.received == 0 ? "no scan has come yet" : "no scans come any more";
  }
  if (!IsComplete(counts)) return "scans were left out";
  if (counts.waiting > kManyWait) return "the SLAM is behind: scans wait, and map -> odom is old";
  return "";
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
