// SPDX-License-Identifier: BSD-3-Clause
// Degrees, the unit of reported angles.
#ifndef GMAPPING_SPA_EXPERIMENTS_METRICS_ANGLES_H_
#define GMAPPING_SPA_EXPERIMENTS_METRICS_ANGLES_H_

#include <cmath>
#include <numbers>

namespace gmapping_spa::metrics {

// Absolute value in degrees of an angle in radians.
inline double AbsDegrees(double angle_rad) {
  return std::abs(angle_rad) * 180.0 / std::numbers::pi;
}

}  // namespace gmapping_spa::metrics

#endif  // GMAPPING_SPA_EXPERIMENTS_METRICS_ANGLES_H_
