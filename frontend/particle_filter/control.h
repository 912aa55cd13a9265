// SPDX-License-Identifier: BSD-3-Clause
// The control input of one step of the filter.
#ifndef GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_CONTROL_H_
#define GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_CONTROL_H_

#include <vector>

#include "backend/se2.h"

namespace gmapping_spa::particle_filter {

// A motion since the step before.
struct Control {
  backend::SE2 motion;
  double probability = 1.0;
  double noise = 1.0;  // factor on the motion model's standard deviations
  // The same motion scan by scan, each increment in the robot frame before it. Empty where there is
  // one scan a step.
  std::vector<backend::SE2> increments = {};
};

}  // namespace gmapping_spa::particle_filter

#endif  // GMAPPING_SPA_FRONTEND_PARTICLE_FILTER_CONTROL_H_
