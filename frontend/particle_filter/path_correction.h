// SPDX-License-Identifier: BSD-3-Clause
// What a back end found wrong with a path.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PATH_CORRECTION_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PATH_CORRECTION_H_

#include <algorithm>
#include <vector>

#include "backend/se2.h"

namespace gmapping_spa::particle_filter {

// The poses of steps 0, 1, ... of one path before and after optimization. At least one.
struct PathCorrection {
  std::vector<backend::SE2> before;
  std::vector<backend::SE2> after;

  // A pose of some path at `step`, as near the corrected path as it was to the uncorrected one.
  // Steps after the last one move with it.
  backend::SE2 Apply(int step, const backend::SE2& world_T_robot) const {
    const std::size_t k = std::min<std::size_t>(step, before.size() - 1);
    return after[k] * Between(before[k], world_T_robot);  // eq. (14): x + dx, as a composition
  }
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_PATH_CORRECTION_H_
