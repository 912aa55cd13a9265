// SPDX-License-Identifier: BSD-3-Clause
// How much of a dense scan a scan of few beams is worth.
#ifndef GMAPPING_SPA_FRONTEND_SCAN_DENSITY_H_
#define GMAPPING_SPA_FRONTEND_SCAN_DENSITY_H_

#include <algorithm>
#include <cmath>

#include "frontend/sensor/laser_scan.h"

namespace gmapping_spa::frontend {

// A map of a scan each half metre has walls without holes from so many beams on.
inline constexpr double kDenseBeams = 90.0;

// What a scan of few beams is worth, in scans of many, in [0.01, 1]: such scans are to be used the
// more often. Falls with the square of the number of beams: each scan has fewer, and fewer of them
// fit what the others saw.
inline double ScanDensity(const sensor::LaserScan& scan) {
  const double part = std::clamp(static_cast<double>(scan.beams.size()) / kDenseBeams, 0.1, 1.0);
  return part * part;
}

// The same for an update of the filter, which costs more than entering a scan into the map of the
// last metres: falls with the number of beams to the power of 1.5.
inline double UpdateDensity(const sensor::LaserScan& scan) {
  return std::pow(ScanDensity(scan), 0.75);
}

}  // namespace gmapping_spa::frontend

#endif  // GMAPPING_SPA_FRONTEND_SCAN_DENSITY_H_
