// SPDX-License-Identifier: BSD-3-Clause
// Where the scans of a node went. Keeps to C++17, as node_output.h does.
#ifndef GMAPPING_SPA_EXPERIMENTS_ROS_SCAN_COUNTS_H_
#define GMAPPING_SPA_EXPERIMENTS_ROS_SCAN_COUNTS_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gmapping_spa::ros {

// received = throttled + refused + after_time_jump + waiting + used, and
// some that are held until later ones and their odometry have come.
struct ScanCounts {
  std::int64_t lost = 0;  // on the way here, as gaps in their numbers tell
  std::int64_t received = 0;
  std::int64_t throttled = 0;           // left out by throttle_scans
  std::int64_t refused = 0;             // for want of room
  std::int64_t after_time_jump = 0;     // refused, as the clock went back
  std::int64_t waiting = 0;             // for the SLAM
  std::int64_t used = 0;                // by the SLAM
  std::int64_t transforms_refused = 0;  // messages, for want of room
  double silent_s = 0.0;                // wall time since the last one came, or since the start
};

// Whether all that came is used, was to be left out, or waits.
bool IsComplete(const ScanCounts& counts);

// What a person has to look after, in a line that stays the same while it is so; empty: nothing.
std::string ProblemOf(const ScanCounts& counts);

// By the names above.
std::vector<std::pair<std::string, std::int64_t>> NamedCounts(const ScanCounts& counts);

}  // namespace gmapping_spa::ros

#endif  // GMAPPING_SPA_EXPERIMENTS_ROS_SCAN_COUNTS_H_
