// SPDX-License-Identifier: BSD-3-Clause
// Scans on a drive around a loop, by wheels that lead astray.
#ifndef GMAPPING_SPA_TESTS_FRONTEND_DRIFTING_SCANS_H_
#define GMAPPING_SPA_TESTS_FRONTEND_DRIFTING_SCANS_H_

#include <cstddef>
#include <vector>

#include "tests/frontend/loop_closure/loop_world.h"

namespace gmapping_spa::synthetic {

// What is seen at each of these poses on the Ring. The heading by the wheels drifts by 0.4 deg a
// metre.
inline std::vector<sensor::LaserScan> DriftingScans(const std::vector<backend::SE2>& truth) {
  auto scans = ScansAt(truth, Ring(), {.beams = 91, .usable_range_m = 8.0});
  const auto wheels = WithDrift(truth, {.scale = 1.03, .rad_per_m = 0.007}, {30, -20, 2});
  for (std::size_t k = 0; k < scans.size(); ++k) scans[k].odom_T_robot = wheels[k];
  return scans;
}

}  // namespace gmapping_spa::synthetic

#endif  // GMAPPING_SPA_TESTS_FRONTEND_DRIFTING_SCANS_H_
